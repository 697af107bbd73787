! SPDX-License-Identifier: MIT
! Poisson's equation with linear tetrahedra in FORTRAN 77:
!
!     -div grad u = 3 pi**2 u   in the unit cube, u = 0 on its boundary,
!
! whose solution is sin(pi x) sin(pi y) sin(pi z) when the right side is
! that function's. Two meshes show the rate at which the error falls.
!
! The mesh is mgdt's. Its edges are the pattern of the matrix, its hull is
! the boundary.
      PROGRAM POISON
      IMPLICIT NONE
      DOUBLE PRECISION E1, E2, RATE
      CALL SOLVE(8, E1)
      CALL SOLVE(16, E2)
      RATE = LOG(E1/E2)/LOG(2.0D0)
      WRITE (*, '(A, F6.2)') 'rate of convergence', RATE
      IF (RATE .LT. 1.8D0 .OR. RATE .GT. 2.2D0) STOP 1
      END

! Solves on M cells a side; ERR is the error in the L2 norm.
      SUBROUTINE SOLVE(M, ERR)
      IMPLICIT NONE
      INTEGER M
      DOUBLE PRECISION ERR
      INTEGER MAXP, MAXT, MAXF, MAXE
      PARAMETER (MAXP = 10000, MAXT = 60000)
      PARAMETER (MAXF = 4000, MAXE = 80000)
      DOUBLE PRECISION XYZ(3, MAXP), DIAG(MAXP), UPPER(MAXE)
      DOUBLE PRECISION F(MAXP), U(MAXP), LUMP(MAXP)
      DOUBLE PRECISION WORK(MAXP, 3)
      INTEGER ITET(4, MAXT), IFAC(3, MAXF), IEDG(2, MAXE)
      INTEGER IROW(MAXP + 1), H(4)
      LOGICAL FIXED(MAXP)
      INTEGER NP, NT, NF, NE, ITER, IERR, I, K
      DOUBLE PRECISION EXACT, X
      INCLUDE 'mgdt_f77.inc'
! F77 keeps large arrays out of the stack.
      SAVE XYZ, DIAG, UPPER, F, U, LUMP, WORK, ITET, IFAC, IEDG
      SAVE IROW, FIXED

      CALL POINTS(M, NP, XYZ)
      CALL MGKIND(MGKI, MGKD, IERR)
      IF (IERR .NE. MGOK) CALL KINDS
      CALL MGNEW(H, IERR)
      IF (IERR .NE. 0) CALL GIVEUP(H, IERR)
      CALL MGINS(H, NP, XYZ, IERR)
      IF (IERR .EQ. 0) CALL MGNTET(H, NT, IERR)
      IF (IERR .EQ. 0) CALL MGTETS(H, MAXT, ITET, IERR)
      IF (IERR .EQ. 0) CALL MGNHUL(H, NF, IERR)
      IF (IERR .EQ. 0) CALL MGHULL(H, MAXF, IFAC, IERR)
      IF (IERR .EQ. 0) CALL MGNEDG(H, NE, IERR)
      IF (IERR .EQ. 0) CALL MGEDGS(H, MAXE, IEDG, IERR)
      IF (IERR .NE. 0) CALL GIVEUP(H, IERR)
      CALL MGFREE(H, IERR)

      DO 10 I = 1, NP
        FIXED(I) = .FALSE.
   10 CONTINUE
      DO 30 K = 1, NF
        DO 20 I = 1, 3
          FIXED(IFAC(I, K)) = .TRUE.
   20   CONTINUE
   30 CONTINUE

      CALL PATERN(NP, NE, IEDG, IROW)
      CALL ASSMBL(NP, NT, NE, XYZ, ITET, IEDG, IROW, FIXED, DIAG,
     &            UPPER, F, LUMP)
      CALL CONGRA(NP, NE, IEDG, DIAG, UPPER, F, U, WORK, ITER)

      ERR = 0
      DO 40 I = 1, NP
        X = U(I) - EXACT(XYZ(1, I))
        ERR = ERR + LUMP(I)*X*X
   40 CONTINUE
      ERR = SQRT(ERR)
      WRITE (*, '(I6, A, I7, A, I4, A, ES10.3)') NP, ' points,', NT,
     &    ' tetrahedra,', ITER, ' iterations, error', ERR
      END

! The corners of a grid of cells, and a point near the middle of each
! cell: such points give tetrahedra of good shape.
      SUBROUTINE POINTS(M, NP, XYZ)
      IMPLICIT NONE
      INTEGER M, NP, I, J, K, L, ISEED, IJK(3)
      DOUBLE PRECISION XYZ(3, *)
      NP = 0
      ISEED = 1
      DO 40 K = 0, M
        DO 30 J = 0, M
          DO 20 I = 0, M
            IJK(1) = I
            IJK(2) = J
            IJK(3) = K
            NP = NP + 1
            DO 10 L = 1, 3
              XYZ(L, NP) = IJK(L)/DBLE(M)
   10       CONTINUE
            IF (MAX(I, J, K) .EQ. M) GO TO 20
            NP = NP + 1
            DO 15 L = 1, 3
              ISEED = MOD(ISEED*1103 + 12345, 65536)
              XYZ(L, NP) = (IJK(L) + 0.45D0 + ISEED/655360.0D0)/M
   15       CONTINUE
   20     CONTINUE
   30   CONTINUE
   40 CONTINUE
      END

! The upper triangle by rows: edges sorted by their lesser point, row I in
! IROW(I) to IROW(I + 1) - 1. mgdt gives them by tetrahedra, so they are
! sorted here by counting.
      SUBROUTINE PATERN(NP, NE, IEDG, IROW)
      IMPLICIT NONE
      INTEGER NP, NE, IEDG(2, NE), IROW(NP + 1)
      INTEGER MAXE
      PARAMETER (MAXE = 80000)
      INTEGER JCOL(MAXE), I, K
      SAVE JCOL
      DO 10 I = 1, NP + 1
        IROW(I) = 0
   10 CONTINUE
      DO 20 K = 1, NE
        I = IEDG(1, K)
        IROW(I) = IROW(I) + 1
   20 CONTINUE
      DO 30 I = 2, NP + 1
        IROW(I) = IROW(I) + IROW(I - 1)
   30 CONTINUE
      DO 40 K = NE, 1, -1
        I = IEDG(1, K)
        JCOL(IROW(I)) = IEDG(2, K)
        IROW(I) = IROW(I) - 1
   40 CONTINUE
      DO 60 I = 1, NP
        IROW(I) = IROW(I) + 1
   60 CONTINUE
      IROW(NP + 1) = NE + 1
      DO 80 I = 1, NP
        DO 70 K = IROW(I), IROW(I + 1) - 1
          IEDG(1, K) = I
          IEDG(2, K) = JCOL(K)
   70   CONTINUE
   80 CONTINUE
      END

! Stiffness matrix, load and lumped mass. Rows of fixed points are those
! of the unit matrix.
      SUBROUTINE ASSMBL(NP, NT, NE, XYZ, ITET, IEDG, IROW, FIXED, DIAG,
     &                  UPPER, F, LUMP)
      IMPLICIT NONE
      INTEGER NP, NT, NE
      INTEGER ITET(4, NT), IEDG(2, NE), IROW(NP + 1)
      LOGICAL FIXED(NP)
      DOUBLE PRECISION XYZ(3, NP), DIAG(NP), UPPER(NE), F(NP), LUMP(NP)
      DOUBLE PRECISION G(3, 4), VOLUME, S, PI, EXACT
      INTEGER I, J, K, L, IA, IB
      PI = 4*ATAN(1.0D0)
      DO 10 I = 1, NP
        DIAG(I) = 0
        LUMP(I) = 0
   10 CONTINUE
      DO 20 L = 1, NE
        UPPER(L) = 0
   20 CONTINUE
      DO 60 K = 1, NT
        CALL GRADS(XYZ, ITET(1, K), G, VOLUME)
        DO 50 I = 1, 4
          IA = ITET(I, K)
          LUMP(IA) = LUMP(IA) + VOLUME/4
          DO 40 J = 1, 4
            IB = ITET(J, K)
            S = VOLUME*(G(1, I)*G(1, J) + G(2, I)*G(2, J) +
     &                  G(3, I)*G(3, J))
            IF (IA .EQ. IB) DIAG(IA) = DIAG(IA) + S
            IF (IA .GE. IB .OR. FIXED(IA) .OR. FIXED(IB)) GO TO 40
            L = IROW(IA)
   30       IF (IEDG(2, L) .NE. IB) THEN
              L = L + 1
              GO TO 30
            END IF
            UPPER(L) = UPPER(L) + S
   40     CONTINUE
   50   CONTINUE
   60 CONTINUE
      DO 70 I = 1, NP
        F(I) = LUMP(I)*3*PI**2*EXACT(XYZ(1, I))
        IF (FIXED(I)) THEN
          DIAG(I) = 1
          F(I) = 0
        END IF
   70 CONTINUE
      END

! Gradients of a tetrahedron's four linear functions, and its volume. mgdt
! orients tetrahedra positively, so that the volume needs no ABS.
      SUBROUTINE GRADS(XYZ, IV, G, VOLUME)
      IMPLICIT NONE
      INTEGER IV(4), I, L
      DOUBLE PRECISION XYZ(3, *), G(3, 4), VOLUME, A(3, 3), DET
      DO 20 I = 1, 3
        DO 10 L = 1, 3
          A(L, I) = XYZ(L, IV(I + 1)) - XYZ(L, IV(1))
   10   CONTINUE
   20 CONTINUE
      CALL CROSS(A(1, 2), A(1, 3), G(1, 2))
      CALL CROSS(A(1, 3), A(1, 1), G(1, 3))
      CALL CROSS(A(1, 1), A(1, 2), G(1, 4))
      DET = A(1, 1)*G(1, 2) + A(2, 1)*G(2, 2) + A(3, 1)*G(3, 2)
      VOLUME = DET/6
      DO 40 L = 1, 3
        DO 30 I = 2, 4
          G(L, I) = G(L, I)/DET
   30   CONTINUE
        G(L, 1) = -G(L, 2) - G(L, 3) - G(L, 4)
   40 CONTINUE
      END

      SUBROUTINE CROSS(A, B, C)
      IMPLICIT NONE
      DOUBLE PRECISION A(3), B(3), C(3)
      C(1) = A(2)*B(3) - A(3)*B(2)
      C(2) = A(3)*B(1) - A(1)*B(3)
      C(3) = A(1)*B(2) - A(2)*B(1)
      END

! Conjugate gradients, preconditioned by the diagonal.
      SUBROUTINE CONGRA(NP, NE, IEDG, DIAG, UPPER, F, U, WORK, ITER)
      IMPLICIT NONE
      INTEGER NP, NE, IEDG(2, NE), ITER, I, K
      DOUBLE PRECISION DIAG(NP), UPPER(NE), F(NP), U(NP), WORK(NP, 3)
      DOUBLE PRECISION RZ, RZNEW, RZ0, PAP, ALPHA, BETA
      RZ = 0
      DO 10 I = 1, NP
        U(I) = 0
        WORK(I, 1) = F(I)
        WORK(I, 2) = F(I)/DIAG(I)
        RZ = RZ + F(I)*WORK(I, 2)
   10 CONTINUE
      RZ0 = RZ
      DO 60 ITER = 1, 1000
        DO 20 I = 1, NP
          WORK(I, 3) = DIAG(I)*WORK(I, 2)
   20   CONTINUE
        DO 30 K = 1, NE
          WORK(IEDG(1, K), 3) = WORK(IEDG(1, K), 3) +
     &        UPPER(K)*WORK(IEDG(2, K), 2)
          WORK(IEDG(2, K), 3) = WORK(IEDG(2, K), 3) +
     &        UPPER(K)*WORK(IEDG(1, K), 2)
   30   CONTINUE
        PAP = 0
        DO 40 I = 1, NP
          PAP = PAP + WORK(I, 2)*WORK(I, 3)
   40   CONTINUE
        ALPHA = RZ/PAP
        RZNEW = 0
        DO 50 I = 1, NP
          U(I) = U(I) + ALPHA*WORK(I, 2)
          WORK(I, 1) = WORK(I, 1) - ALPHA*WORK(I, 3)
          RZNEW = RZNEW + WORK(I, 1)**2/DIAG(I)
   50   CONTINUE
        IF (RZNEW .LE. 1D-20*RZ0) RETURN
        BETA = RZNEW/RZ
        RZ = RZNEW
        DO 55 I = 1, NP
          WORK(I, 2) = WORK(I, 1)/DIAG(I) + BETA*WORK(I, 2)
   55   CONTINUE
   60 CONTINUE
      WRITE (*, '(A)') 'no convergence'
      STOP 1
      END

      DOUBLE PRECISION FUNCTION EXACT(P)
      IMPLICIT NONE
      DOUBLE PRECISION P(3), PI
      PI = 4*ATAN(1.0D0)
      EXACT = SIN(PI*P(1))*SIN(PI*P(2))*SIN(PI*P(3))
      END

      SUBROUTINE KINDS
      IMPLICIT NONE
      WRITE (*, '(A)') 'mgdt was compiled with other kinds of numbers'
      STOP 1
      END

      SUBROUTINE GIVEUP(H, IERR)
      IMPLICIT NONE
      INTEGER H(4), IERR, JERR
      CHARACTER*256 TEXT
      CALL MGTEXT(IERR, TEXT, JERR)
      WRITE (*, '(2A)') 'mgdt: ', TEXT(1:70)
      CALL MGERR(H, TEXT, JERR)
      IF (JERR .EQ. 0) WRITE (*, '(2A)') 'mgdt: ', TEXT(1:70)
      STOP 1
      END
