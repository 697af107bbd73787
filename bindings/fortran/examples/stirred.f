! SPDX-License-Identifier: MIT
! A material that is stirred in a box, in FORTRAN 77. The program has its
! own mesh of tetrahedra, and moves the points with the material in steps.
! Without mgdt tetrahedra are inverted soon. Here mgdt improves the mesh
! between the steps: it moves points, also within the walls of the box, and
! changes tetrahedra; then the program takes the temperatures at the new
! points from the mesh before.
      PROGRAM STIRRD
      IMPLICIT NONE
      INTEGER MAXP, MAXT, NSTEPS, M
      PARAMETER (MAXP = 4000, MAXT = 20000, NSTEPS = 30, M = 8)
      DOUBLE PRECISION XYZ(3, MAXP), TEMP(MAXP), HEAT, HEAT0, VOLUME
      DOUBLE PRECISION LEAST, VLEAST
      INTEGER ITET(4, MAXT), NP, NT, STEP, I, IERR
      INCLUDE 'mgdt_f77.inc'
      SAVE XYZ, TEMP, ITET

      CALL MGKIND(MGKI, MGKD, IERR)
      IF (IERR .NE. MGOK) STOP 8

! Without improvement.
      CALL LATICE(M, NP, XYZ, NT, ITET)
      DO 5 I = 1, NP
        TEMP(I) = 0.0D0
    5 CONTINUE
      DO 10 STEP = 1, NSTEPS
        CALL MOVE(NP, XYZ)
        CALL VOLUMS(NP, XYZ, NT, ITET, TEMP, VOLUME, VLEAST, HEAT)
        IF (VLEAST .LE. 0.0D0) GO TO 20
   10 CONTINUE
   20 CONTINUE
      IF (VLEAST .GT. 0.0D0) STOP 1
      WRITE (*, '(A, I3)') 'without improvement: inverted at step', STEP

! With improvement. The temperature is 1 at one end and 0 at the other.
      CALL LATICE(M, NP, XYZ, NT, ITET)
      DO 30 I = 1, NP
        TEMP(I) = XYZ(1, I)
   30 CONTINUE
      CALL VOLUMS(NP, XYZ, NT, ITET, TEMP, VOLUME, VLEAST, HEAT0)
      DO 40 STEP = 1, NSTEPS
        CALL MOVE(NP, XYZ)
        CALL BETTER(MAXP, NP, XYZ, MAXT, NT, ITET, TEMP, LEAST)
        IF (LEAST .LT. 20.0D0) STOP 2
   40 CONTINUE
      CALL VOLUMS(NP, XYZ, NT, ITET, TEMP, VOLUME, VLEAST, HEAT)
      WRITE (*, '(A, I3, A, F5.1)') 'with improvement: after step',
     &      NSTEPS, ' the least angle is', LEAST
      WRITE (*, '(A, F7.4, A, F7.4, A, F7.4)') 'volume', VOLUME,
     &      ', heat before', HEAT0, ' and after', HEAT
      IF (VLEAST .LE. 0.0D0) STOP 3
      IF (ABS(VOLUME - 1.0D0) .GT. 1.0D-9) STOP 4
      IF (ABS(HEAT - HEAT0) .GT. 0.01D0*HEAT0) STOP 5
      END

! Improves the mesh, and takes the temperatures along. LEAST is the least
! angle between two faces of a tetrahedron, in degrees.
      SUBROUTINE BETTER(MAXP, NP, XYZ, MAXT, NT, ITET, TEMP, LEAST)
      IMPLICIT NONE
      INTEGER MAXP, NP, MAXT, NT, ITET(4, MAXT)
      DOUBLE PRECISION XYZ(3, MAXP), TEMP(MAXP), LEAST
      INTEGER MAXM
      PARAMETER (MAXM = 20000)
      DOUBLE PRECISION SHAPES(2, 3), NEWT(MAXM)
      INTEGER BEFORE(4), AFTER(4), MARK(MAXM), IERR, I
      INCLUDE 'mgdt_f77.inc'
      SAVE NEWT, MARK

! The mesh as it is, for the temperatures. All tetrahedra are of one
! material.
      DO 10 I = 1, NT
        MARK(I) = 1
   10 CONTINUE
      CALL MGUNEW(BEFORE, IERR)
      IF (IERR .EQ. MGOK) CALL MGUINP(BEFORE, NP, XYZ, IERR)
      IF (IERR .EQ. MGOK) CALL MGUINT(BEFORE, NT, ITET, MARK, IERR)
      IF (IERR .EQ. MGOK) CALL MGUBLD(BEFORE, IERR)
      IF (IERR .NE. MGOK) CALL GIVEUP(BEFORE, IERR)

      CALL MGUNEW(AFTER, IERR)
      IF (IERR .EQ. MGOK) CALL MGUINP(AFTER, NP, XYZ, IERR)
      IF (IERR .EQ. MGOK) CALL MGUINT(AFTER, NT, ITET, MARK, IERR)
      IF (IERR .EQ. MGOK) CALL MGUBLD(AFTER, IERR)
! Points of the walls may move within these, and points of any kind may
! go. Two passes that serve the mean of all tetrahedra keep them from the
! limit: without these, each step has to add points.
      IF (IERR .EQ. MGOK) CALL MGUOPT(AFTER, MGUBND, MGUSLD, IERR)
      IF (IERR .EQ. MGOK) CALL MGUOPT(AFTER, MGUPNT, MGURMV, IERR)
      IF (IERR .EQ. MGOK) CALL MGUOPT(AFTER, MGUGOA, 25, IERR)
      IF (IERR .EQ. MGOK) CALL MGUOPT(AFTER, MGUMPA, 2, IERR)
      IF (IERR .EQ. MGOK) CALL MGUIMP(AFTER, IERR)
! What was added has numbers after those of the points before.
      IF (IERR .EQ. MGOK) CALL MGUNUM(AFTER, MGUNPT, NP, IERR)
      IF (IERR .EQ. MGOK) CALL MGUNUM(AFTER, MGUNTE, NT, IERR)
      IF (IERR .EQ. MGOK) CALL MGUARR(AFTER, MGUTET, 4*MAXT, ITET, IERR)
      IF (IERR .EQ. MGOK) CALL MGUDBL(AFTER, MGUPTS, 3*MAXP, XYZ, IERR)
      IF (IERR .EQ. MGOK) CALL MGUDBL(AFTER, MGUSHA, 6, SHAPES, IERR)
      IF (IERR .NE. MGOK) CALL GIVEUP(AFTER, IERR)
      LEAST = SHAPES(2, 1)

! A rounded point may lie outside by the last digit: it takes what the
! nearest place of the boundary has.
      CALL MGUVAL(BEFORE, MGXBOU, 1, TEMP, NP, XYZ, NEWT, IERR)
      IF (IERR .NE. MGOK) CALL GIVEUP(BEFORE, IERR)
      DO 20 I = 1, NP
        TEMP(I) = NEWT(I)
   20 CONTINUE
      CALL MGUFRE(BEFORE, IERR)
      CALL MGUFRE(AFTER, IERR)
      END

! Says why mgdt has refused a call, and ends.
      SUBROUTINE GIVEUP(H, IERR)
      IMPLICIT NONE
      INTEGER H(4), IERR, IGNORE
      CHARACTER*200 TEXT
      CALL MGUERR(H, TEXT, IGNORE)
      WRITE (*, '(A, I4, 2A)') 'mgdt status', IERR, ': ', TEXT
      STOP 9
      END

! A unit cube of M cells a side, each of six tetrahedra around a diagonal.
      SUBROUTINE LATICE(M, NP, XYZ, NT, ITET)
      IMPLICIT NONE
      INTEGER M, NP, NT, ITET(4, *)
      DOUBLE PRECISION XYZ(3, *)
      INTEGER I, J, K, L, C, S, STRIDE(3), FIRST(6), SECOND(6)
      DATA FIRST /1, 1, 2, 2, 3, 3/
      DATA SECOND /2, 3, 3, 1, 1, 2/

      NP = 0
      NT = 0
      STRIDE(1) = 1
      STRIDE(2) = M + 1
      STRIDE(3) = (M + 1)*(M + 1)
      DO 40 K = 0, M
        DO 30 J = 0, M
          DO 20 I = 0, M
            NP = NP + 1
            XYZ(1, NP) = DBLE(I)/M
            XYZ(2, NP) = DBLE(J)/M
            XYZ(3, NP) = DBLE(K)/M
            IF (MAX(I, J, K) .EQ. M) GO TO 20
            DO 10 L = 1, 6
              NT = NT + 1
              C = NP + STRIDE(FIRST(L))
! Every other one is a mirror image: two corners change places.
              S = 1 - MOD(L, 2)
              ITET(1, NT) = NP
              ITET(2 + S, NT) = C
              ITET(3 - S, NT) = C + STRIDE(SECOND(L))
              ITET(4, NT) = NP + STRIDE(1) + STRIDE(2) + STRIDE(3)
   10       CONTINUE
   20     CONTINUE
   30   CONTINUE
   40 CONTINUE
      END

! Moves the points by a step of an eddy in the middle of the box, which
! vanishes at its walls.
      SUBROUTINE MOVE(NP, XYZ)
      IMPLICIT NONE
      INTEGER NP, I
      DOUBLE PRECISION XYZ(3, NP), PI, DT, U, V, X, Y
      PARAMETER (PI = 3.14159265358979324D0, DT = 0.02D0)
      DO 10 I = 1, NP
        CALL FLOW(XYZ(1, I), XYZ(2, I), U, V)
        X = XYZ(1, I) + 0.5D0*DT*U
        Y = XYZ(2, I) + 0.5D0*DT*V
        CALL FLOW(X, Y, U, V)
        XYZ(1, I) = XYZ(1, I) + DT*U
        XYZ(2, I) = XYZ(2, I) + DT*V
   10 CONTINUE
      END

      SUBROUTINE FLOW(X, Y, U, V)
      IMPLICIT NONE
      DOUBLE PRECISION X, Y, U, V, PI
      PARAMETER (PI = 3.14159265358979324D0)
      U = SIN(PI*X)**2*SIN(2.0D0*PI*Y)
      V = -SIN(2.0D0*PI*X)*SIN(PI*Y)**2
      END

! The volume of all tetrahedra, that of the least, and the integral of the
! temperature.
      SUBROUTINE VOLUMS(NP, XYZ, NT, ITET, TEMP, VOLUME, VLEAST, HEAT)
      IMPLICIT NONE
      INTEGER NP, NT, ITET(4, NT)
      DOUBLE PRECISION XYZ(3, NP), TEMP(NP), VOLUME, VLEAST, HEAT
      DOUBLE PRECISION E(3, 3), V
      INTEGER I, J, K
      VOLUME = 0.0D0
      HEAT = 0.0D0
      VLEAST = 1.0D0
      DO 30 K = 1, NT
        DO 20 J = 1, 3
          DO 10 I = 1, 3
            E(I, J) = XYZ(I, ITET(J + 1, K)) - XYZ(I, ITET(1, K))
   10     CONTINUE
   20   CONTINUE
        V = (E(1, 1)*(E(2, 2)*E(3, 3) - E(3, 2)*E(2, 3))
     &     + E(2, 1)*(E(3, 2)*E(1, 3) - E(1, 2)*E(3, 3))
     &     + E(3, 1)*(E(1, 2)*E(2, 3) - E(2, 2)*E(1, 3)))/6.0D0
        VOLUME = VOLUME + V
        VLEAST = MIN(VLEAST, V)
        HEAT = HEAT + V*0.25D0*(TEMP(ITET(1, K)) + TEMP(ITET(2, K))
     &                        + TEMP(ITET(3, K)) + TEMP(ITET(4, K)))
   30 CONTINUE
      END
