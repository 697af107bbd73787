! SPDX-License-Identifier: MIT
! Every FORTRAN 77 subroutine from a fixed-form program with an implicit
! interface. Compiled with several sets of flags.
      PROGRAM TSTF77
      IMPLICIT NONE
      INTEGER NCHK, NBAD
      COMMON /COUNT/ NCHK, NBAD
      NCHK = 0
      NBAD = 0
      CALL TSTKND
      CALL TSTARR
      CALL TSTLAY
      CALL TSTQUE
      CALL TSTSET
      CALL TSTTXT
      CALL TSTPRO
      CALL TSTCHG
      CALL TSTVOR
      CALL TSTDOM
      CALL TSTBOX
      CALL TSTBAD
      WRITE (*, '(I6, A, I6, A)') NCHK, ' checks,', NBAD, ' failed'
      IF (NBAD .GT. 0 .OR. NCHK .EQ. 0) STOP 1
      END

      SUBROUTINE EXPECT(YES, WHAT)
      IMPLICIT NONE
      LOGICAL YES
      CHARACTER*(*) WHAT
      INTEGER NCHK, NBAD
      COMMON /COUNT/ NCHK, NBAD
      NCHK = NCHK + 1
      IF (YES) RETURN
      NBAD = NBAD + 1
      WRITE (*, '(2A)') 'failed: ', WHAT
      END

! A call that must have gone well.
      SUBROUTINE GOOD(H, IERR, WHAT)
      IMPLICIT NONE
      INTEGER H(4), IERR, JERR
      CHARACTER*(*) WHAT
      CHARACTER*256 TEXT
      CALL EXPECT(IERR .EQ. 0, WHAT)
      IF (IERR .EQ. 0) RETURN
      CALL MGERR(H, TEXT, JERR)
      WRITE (*, '(I6, 2X, A)') IERR, TEXT(1:100)
      END

! A call that must have failed, with a message that begins so.
      SUBROUTINE BAD(H, IERR, IWANT, PART)
      IMPLICIT NONE
      INTEGER H(4), IERR, IWANT, JERR
      CHARACTER*(*) PART
      CHARACTER*256 TEXT
      CALL EXPECT(IERR .EQ. IWANT, 'status: '//PART)
      CALL MGERR(H, TEXT, JERR)
      CALL EXPECT(INDEX(TEXT, PART) .GT. 0, 'message: '//PART)
      IF (INDEX(TEXT, PART) .EQ. 0) WRITE (*, '(A)') TEXT(1:100)
      END

! N points with coordinates that are multiples of 2**-10; point N repeats
! the first.
      SUBROUTINE MKPTS(N, XYZ)
      IMPLICIT NONE
      INTEGER N, I, K, ISEED
      DOUBLE PRECISION XYZ(3, N)
      ISEED = 1
      DO 20 I = 1, N
        DO 10 K = 1, 3
          ISEED = MOD(ISEED*1103 + 12345, 65536)
          XYZ(K, I) = (ISEED/64)/1024.0D0
   10   CONTINUE
   20 CONTINUE
      DO 30 K = 1, 3
        XYZ(K, N) = XYZ(K, 1)
   30 CONTINUE
      END

      DOUBLE PRECISION FUNCTION VOL6(A, B, C, D)
      IMPLICIT NONE
      DOUBLE PRECISION A(3), B(3), C(3), D(3), P(3), Q(3), R(3)
      INTEGER K
      DO 10 K = 1, 3
        P(K) = B(K) - A(K)
        Q(K) = C(K) - A(K)
        R(K) = D(K) - A(K)
   10 CONTINUE
      VOL6 = R(1)*(P(2)*Q(3) - P(3)*Q(2)) + R(2)*(P(3)*Q(1) -
     &    P(1)*Q(3)) + R(3)*(P(1)*Q(2) - P(2)*Q(1))
      END

! Points, counts and arrays.
      SUBROUTINE TSTARR
      IMPLICIT NONE
      INTEGER N, MAXT
      PARAMETER (N = 200, MAXT = 2500)
      INTEGER H(4), IERR, NPT, NVT, NT, NF, NE, NL, IDIM, I, K, J, L
      INTEGER ITET(4, MAXT), INBR(4, MAXT), IFAC(3, MAXT)
      INTEGER IEDG(2, MAXT), MAP(N), IOFF(N + 1), LIST(4*MAXT)
      INTEGER ITET0(4, MAXT), NONE, NB, IOFF2(N + 1), LIST2(4*MAXT)
      INTEGER IEDG2(2, MAXT), JOFF(3), JPT(40)
      DOUBLE PRECISION CENTER(3, MAXT), R2(MAXT), D
      DOUBLE PRECISION XYZ(3, N), X(2*N), Y(2*N), Z(2*N), V, VH, VOL6
      DOUBLE PRECISION O(3), BOX(4, 6), CELL(N)
      LOGICAL YES
      SAVE
      DATA O /3*0.0D0/
      DATA BOX /1D0, 0D0, 0D0, 2D0, -1D0, 0D0, 0D0, 1D0,
     &          0D0, 1D0, 0D0, 2D0, 0D0, -1D0, 0D0, 1D0,
     &          0D0, 0D0, 1D0, 2D0, 0D0, 0D0, -1D0, 1D0/
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      CALL GOOD(H, IERR, 'MGNEW')
      CALL MGDIM(H, IDIM, IERR)
      CALL EXPECT(IERR .EQ. MGOK .AND. IDIM .EQ. -1, 'empty')
      CALL MGRSV(H, N, IERR)
      CALL GOOD(H, IERR, 'MGRSV')
      CALL MGINS(H, N/2, XYZ, IERR)
      CALL GOOD(H, IERR, 'MGINS')
! The other half from separate arrays, backwards and with gaps.
      DO 10 I = 1, N/2
        X(2*(N/2 - I) + 1) = XYZ(1, N/2 + I)
        Y(2*(N/2 - I) + 1) = XYZ(2, N/2 + I)
        Z(2*(N/2 - I) + 1) = XYZ(3, N/2 + I)
   10 CONTINUE
      CALL MGINSS(H, N/2, X(N - 1), Y(N - 1), Z(N - 1), -2, IERR)
      CALL GOOD(H, IERR, 'MGINSS')
      CALL MGCHK(H, MGCCAN, IERR)
      CALL GOOD(H, IERR, 'MGCHK')
      CALL MGDIM(H, IDIM, IERR)
      CALL MGNPT(H, NPT, IERR)
      CALL GOOD(H, IERR, 'MGNPT')
      CALL MGNVT(H, NVT, IERR)
      CALL GOOD(H, IERR, 'MGNVT')
      CALL MGNTET(H, NT, IERR)
      CALL GOOD(H, IERR, 'MGNTET')
      CALL MGNHUL(H, NF, IERR)
      CALL GOOD(H, IERR, 'MGNHUL')
      CALL MGNEDG(H, NE, IERR)
      CALL GOOD(H, IERR, 'MGNEDG')
      CALL MGNVTT(H, NL, IERR)
      CALL GOOD(H, IERR, 'MGNVTT')
      CALL EXPECT(IDIM .EQ. 3 .AND. NPT .EQ. N, 'dimension, points')
      CALL EXPECT(NVT - NE + (4*NT + NF)/2 - NT .EQ. 1, 'Euler')
      CALL EXPECT(NL .EQ. 4*NT .AND. NVT .LT. N, 'list, duplicate')
      CALL MGNVNB(H, NB, IERR)
      CALL GOOD(H, IERR, 'MGNVNB')
      CALL EXPECT(NB .EQ. 2*NE, 'list of neighbours')

      CALL MGTETS(H, MAXT, ITET, IERR)
      CALL GOOD(H, IERR, 'MGTETS')
      CALL MGNBRS(H, NT, INBR, IERR)
      CALL GOOD(H, IERR, 'MGNBRS')
      CALL MGHULL(H, NF, IFAC, IERR)
      CALL GOOD(H, IERR, 'MGHULL')
      CALL MGEDGS(H, NE, IEDG, IERR)
      CALL GOOD(H, IERR, 'MGEDGS')
      CALL MGMAP(H, N, MAP, IERR)
      CALL GOOD(H, IERR, 'MGMAP')
      CALL MGVTS(H, N + 1, IOFF, NL, LIST, IERR)
      CALL GOOD(H, IERR, 'MGVTS')
      CALL MGVNBS(H, N + 1, IOFF2, NB, LIST2, IERR)
      CALL GOOD(H, IERR, 'MGVNBS')
      CALL EXPECT(IOFF2(N + 1) .EQ. NB + 1, 'end of the neighbours')
      CALL MGGABR(H, MAXT, IEDG2, NB, IERR)
      CALL GOOD(H, IERR, 'MGGABR')
      CALL EXPECT(NB .LT. NE .AND. NB .GE. NVT - 1, 'Gabriel edges')
      CALL MGTREE(H, NVT - 1, IEDG2, NB, IERR)
      CALL GOOD(H, IERR, 'MGTREE')
      CALL EXPECT(NB .EQ. NVT - 1, 'edges of the tree')
      CALL MGTREE(H, NVT - 2, IEDG2, NB, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')
      CALL MGCIRC(H, NT, CENTER, R2, IERR)
      CALL GOOD(H, IERR, 'MGCIRC')
      DO 5 K = 1, 4
        D = 0
        DO 4 J = 1, 3
          D = D + (XYZ(J, ITET(K, 1)) - CENTER(J, 1))**2
    4   CONTINUE
        CALL EXPECT(ABS(D - R2(1)) .LT. 1D-9*(1 + R2(1)), 'radius')
    5 CONTINUE
      CALL MGTMSR(H, MGTRRT, NT, R2, IERR)
      CALL GOOD(H, IERR, 'MGTMSR')
      CALL EXPECT(R2(1) .GT. 0 .AND. R2(1) .LT. 1, 'radius ratio')
      CALL MGTMSR(H, 11, NT, R2, IERR)
      CALL BAD(H, IERR, MGEKEY, 'no measure 11')
      CALL MGALPH(H, 3, NT, R2, IERR)
      CALL GOOD(H, IERR, 'MGALPH')
      CALL EXPECT(ABS(D - R2(1)) .LT. 1D-9*(1 + R2(1)), 'alpha')
      CALL MGASUR(H, 1D9, NF, IFAC, NB, IERR)
      CALL GOOD(H, IERR, 'MGASUR')
      CALL EXPECT(NB .EQ. NF, 'the hull is a surface')
      CALL MGASUR(H, -1D0, NF, IFAC, NB, IERR)
      CALL BAD(H, IERR, MGEARG, 'at least 0')
      CALL MGASOL(H, V, IERR)
      CALL GOOD(H, IERR, 'MGASOL')
      CALL EXPECT(V .GT. 0, 'alpha of one solid')
      CALL MGCELL(H, MGMVOL, 6, BOX, N, CELL, IERR)
      CALL GOOD(H, IERR, 'MGCELL')
      D = 0
      DO 6 K = 1, N
        D = D + CELL(K)
    6 CONTINUE
      CALL EXPECT(ABS(D - 27) .LT. 1D-12, 'cells fill the box')
      CALL MGCELL(H, MGMVOL, 5, BOX, N, CELL, IERR)
      CALL BAD(H, IERR, MGEARG, 'plane 1 has no end')
      CALL MGCELL(H, MGMCEN, 0, BOX, N, CELL, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')

      DO 7 K = 1, N
        CELL(K) = XYZ(1, K) - XYZ(2, K)
    7 CONTINUE
      CALL MGINTP(H, MGISIB, MGXBOU, 1, CELL, 2, BOX, R2, IERR)
      CALL GOOD(H, IERR, 'MGINTP')
      CALL EXPECT(ABS(R2(1)) .LE. 9D0, 'a value')
      CALL MGINTP(H, 11, MGXBOU, 1, CELL, 2, BOX, R2, IERR)
      CALL BAD(H, IERR, MGEKEY, 'there is no method 11')
      CALL MGWGTS(H, MGILIN, MGXNEA, 2, XYZ, 3, JOFF, 40, JPT, R2,
     &            IERR)
      CALL GOOD(H, IERR, 'MGWGTS')
      CALL EXPECT(JOFF(1) .EQ. 1 .AND. JOFF(2) .EQ. 2 .AND.
     &            JOFF(3) .EQ. 3, 'a weight for each point')
      CALL EXPECT(JPT(1) .EQ. 1 .AND. R2(1) .EQ. 1, 'itself')
      CALL MGGRAD(H, 1, CELL, CENTER, IERR)
      CALL GOOD(H, IERR, 'MGGRAD')
      CALL EXPECT(ABS(CENTER(1, 1) - 1) .LT. 1D-12, 'gradient by x')
      CALL EXPECT(ABS(CENTER(2, 1) + 1) .LT. 1D-12, 'gradient by y')

      V = 0
      YES = .TRUE.
      NONE = 0
      DO 40 I = 1, NT
        V = V + VOL6(XYZ(1, ITET(1, I)), XYZ(1, ITET(2, I)),
     &               XYZ(1, ITET(3, I)), XYZ(1, ITET(4, I)))
        DO 30 K = 1, 4
          J = INBR(K, I)
          IF (J .EQ. 0) THEN
            NONE = NONE + 1
          ELSE
            YES = YES .AND. (INBR(1, J) .EQ. I .OR. INBR(2, J) .EQ. I
     &          .OR. INBR(3, J) .EQ. I .OR. INBR(4, J) .EQ. I)
          END IF
   30   CONTINUE
   40 CONTINUE
      CALL EXPECT(YES, 'mutual neighbours')
      CALL EXPECT(NONE .EQ. NF, 'none on the hull')
      VH = 0
      DO 50 I = 1, NF
        VH = VH + VOL6(O, XYZ(1, IFAC(1, I)), XYZ(1, IFAC(2, I)),
     &                 XYZ(1, IFAC(3, I)))
   50 CONTINUE
      CALL EXPECT(V .EQ. VH .AND. V .GT. 0, 'volumes')
      YES = .TRUE.
      DO 60 I = 1, NE
        YES = YES .AND. IEDG(1, I) .LT. IEDG(2, I) .AND.
     &        IEDG(1, I) .GE. 1 .AND. IEDG(2, I) .LE. N
   60 CONTINUE
      CALL EXPECT(YES, 'edges')
      CALL EXPECT(MAP(N) .EQ. 1 .AND. MAP(1) .EQ. 1, 'point map')
      YES = IOFF(1) .EQ. 1 .AND. IOFF(N + 1) .EQ. NL + 1
      DO 80 I = 1, N
        DO 70 K = IOFF(I), IOFF(I + 1) - 1
          L = LIST(K)
          YES = YES .AND. (ITET(1, L) .EQ. I .OR. ITET(2, L) .EQ. I
     &        .OR. ITET(3, L) .EQ. I .OR. ITET(4, L) .EQ. I)
   70   CONTINUE
   80 CONTINUE
      CALL EXPECT(YES, 'tetrahedra around points')

      CALL MGBASE(H, 0, IERR)
      CALL GOOD(H, IERR, 'MGBASE')
      CALL MGTETS(H, NT, ITET0, IERR)
      YES = .TRUE.
      DO 90 I = 1, NT
        YES = YES .AND. ITET0(1, I) .EQ. ITET(1, I) - 1 .AND.
     &        ITET0(4, I) .EQ. ITET(4, I) - 1
   90 CONTINUE
      CALL EXPECT(YES, 'base 0')

      ITET(1, 1) = -5
      CALL MGTETS(H, NT - 1, ITET, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')
      CALL EXPECT(ITET(1, 1) .EQ. -5, 'not touched')
      CALL MGTETS(H, -1, ITET, IERR)
      CALL BAD(H, IERR, MGEARG, 'negative')
      CALL MGVTS(H, N, IOFF, NL, LIST, IERR)
      CALL BAD(H, IERR, MGEBUF, '201 are needed')
      CALL MGCLR(H, IERR)
      CALL GOOD(H, IERR, 'MGCLR')
      CALL MGNPT(H, NPT, IERR)
      CALL EXPECT(NPT .EQ. 0, 'cleared')
      CALL MGFREE(H, IERR)
      CALL GOOD(H, IERR, 'MGFREE')
      END

! Kinds that agree; reals that do not are made of integers here.
      SUBROUTINE TSTKND
      IMPLICIT NONE
      INTEGER IERR, I12(2), I21(2)
      DOUBLE PRECISION TWO
      DATA I12 /1, 2/, I21 /2, 1/, TWO /2D0/
      INCLUDE 'mgdt_f77.inc'
      IERR = -1
      CALL MGKIND(MGKI, MGKD, IERR)
      CALL EXPECT(IERR .EQ. MGOK, 'MGKIND')
      IERR = -1
      CALL MGKIND(I12, 1D0, IERR)
      CALL EXPECT(IERR .EQ. MGOK, 'MGKIND without names')
      IERR = -1
      CALL MGKIND(I21, MGKD, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'MGKIND of other integers')
      IERR = -1
      CALL MGKIND(MGKI, TWO, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'MGKIND of another real')
      END

! Arrays with columns for vertices, or with more rows than vertices.
      SUBROUTINE TSTLAY
      IMPLICIT NONE
      INTEGER N, KTE, LD
      PARAMETER (N = 200, KTE = 1300, LD = 7)
      INTEGER H(4), IERR, NT, NF, NE, I, K, IROW(4, KTE), ICOL(KTE, 4)
      INTEGER ILD(LD, KTE), IPART(3*KTE, 4)
      DOUBLE PRECISION XYZ(3, N)
      LOGICAL YES
      SAVE
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      CALL MGNTET(H, NT, IERR)
      CALL MGNHUL(H, NF, IERR)
      CALL MGNEDG(H, NE, IERR)
      CALL EXPECT(NT .GT. 1024 .AND. NT .LT. KTE, 'tetrahedra')

      CALL MGTETS(H, KTE, IROW, IERR)
      CALL FILL(ILD, LD*KTE)
      CALL FILL(IPART, 12*KTE)
      CALL MGTETI(H, KTE, ICOL, 1, KTE, IERR)
      CALL GOOD(H, IERR, 'MGTETI of columns')
      CALL MGTETI(H, KTE, ILD(3, 1), LD, 1, IERR)
      CALL GOOD(H, IERR, 'MGTETI of rows')
      CALL MGTETI(H, NT, IPART(KTE + 1, 1), 1, 3*KTE, IERR)
      CALL GOOD(H, IERR, 'MGTETI of a part')
      CALL SAME(4, NT, IROW, ICOL, 1, KTE, 'tetrahedra in columns')
      CALL SAME(4, NT, IROW, ILD(3, 1), LD, 1, 'in more rows')
      CALL SAME(4, NT, IROW, IPART(KTE + 1, 1), 1, 3*KTE, 'in a part')
      YES = .TRUE.
      DO 10 I = 1, KTE
        YES = YES .AND. ILD(1, I) .EQ. -5 .AND. ILD(2, I) .EQ. -5 .AND.
     &        ILD(7, I) .EQ. -5
   10 CONTINUE
      DO 30 I = 1, 3*KTE
        IF (I .GT. KTE .AND. I .LE. KTE + NT) GO TO 30
        DO 20 K = 1, 4
          YES = YES .AND. IPART(I, K) .EQ. -5
   20   CONTINUE
   30 CONTINUE
      CALL EXPECT(YES, 'nothing else is touched')
      CALL MGTETI(H, NT, ICOL, 1, NT, IERR)
      CALL SAME(4, NT, IROW, ICOL, 1, NT, 'in columns that fit')
      CALL MGTETI(H, NT, ICOL, 4, 1, IERR)
      CALL SAME(4, NT, IROW, ICOL, 4, 1, 'as MGTETS gives them')
      CALL MGTETI(H, NT, IPART, 8, 2, IERR)
      CALL SAME(4, NT, IROW, IPART, 8, 2, 'every other element')

      CALL MGNBRS(H, KTE, IROW, IERR)
      CALL MGNBRI(H, KTE, ICOL, 1, KTE, IERR)
      CALL GOOD(H, IERR, 'MGNBRI of columns')
      CALL MGNBRI(H, KTE, ILD, LD, 1, IERR)
      CALL GOOD(H, IERR, 'MGNBRI of rows')
      CALL SAME(4, NT, IROW, ICOL, 1, KTE, 'neighbours in columns')
      CALL SAME(4, NT, IROW, ILD, LD, 1, 'in more rows')
      CALL MGHULL(H, KTE, IROW, IERR)
      CALL MGHULI(H, KTE, ICOL, 1, KTE, IERR)
      CALL GOOD(H, IERR, 'MGHULI of columns')
      CALL MGHULI(H, KTE, ILD, LD, 1, IERR)
      CALL GOOD(H, IERR, 'MGHULI of rows')
      CALL SAME(3, NF, IROW, ICOL, 1, KTE, 'hull in columns')
      CALL SAME(3, NF, IROW, ILD, LD, 1, 'in more rows')
      CALL MGEDGS(H, 2*KTE, IROW, IERR)
      CALL MGEDGI(H, 2*KTE, ICOL, 1, 2*KTE, IERR)
      CALL GOOD(H, IERR, 'MGEDGI of columns')
      CALL MGEDGI(H, 2*KTE, ILD, 3, 1, IERR)
      CALL GOOD(H, IERR, 'MGEDGI of rows')
      CALL SAME(2, NE, IROW, ICOL, 1, 2*KTE, 'edges in columns')
      CALL SAME(2, NE, IROW, ILD, 3, 1, 'in more rows')

      CALL FILL(ICOL, 4*KTE)
      CALL MGTETI(H, NT - 1, ICOL, 1, KTE, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')
      CALL MGTETI(H, NT - 1, ICOL, 1, NT - 1, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')
      CALL MGTETI(H, NT - 1, ICOL, LD, 1, IERR)
      CALL BAD(H, IERR, MGEBUF, 'are needed')
      CALL MGTETI(H, -1, ICOL, 1, KTE, IERR)
      CALL BAD(H, IERR, MGEARG, 'negative')
! Increments that put two numbers at one place, or count backwards.
      CALL MGTETI(H, KTE, ICOL, 1, NT, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'columns that overlap')
      CALL MGTETI(H, KTE, ICOL, 3, 1, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'rows that overlap')
      CALL MGTETI(H, KTE, ICOL, 0, 1, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'no increment')
      CALL MGTETI(H, KTE, ICOL, 1, -KTE, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'a negative increment')
      YES = .TRUE.
      DO 50 I = 1, KTE
        DO 40 K = 1, 4
          YES = YES .AND. ICOL(I, K) .EQ. -5
   40   CONTINUE
   50 CONTINUE
      CALL EXPECT(YES, 'refused: nothing is touched')
      CALL MGFREE(H, IERR)
      CALL MGTETI(H, KTE, ICOL, 1, KTE, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGTETI on a bad handle')
      CALL MGTETI(H, KTE, ILD, LD, 1, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'rows of a bad handle')
      END

      SUBROUTINE FILL(IV, N)
      IMPLICIT NONE
      INTEGER N, IV(N), I
      DO 10 I = 1, N
        IV(I) = -5
   10 CONTINUE
      END

      SUBROUTINE SAME(L, N, IROW, IV, INCR, INCV, WHAT)
      IMPLICIT NONE
      INTEGER L, N, IROW(L, N), IV(*), INCR, INCV, I, K
      CHARACTER*(*) WHAT
      LOGICAL YES
      YES = N .GT. 0
      DO 20 I = 1, N
        DO 10 K = 1, L
          YES = YES .AND. IROW(K, I) .EQ.
     &          IV(1 + (I - 1)*INCR + (K - 1)*INCV)
   10   CONTINUE
   20 CONTINUE
      CALL EXPECT(YES, WHAT)
      END

! Location and nearest vertices.
      SUBROUTINE TSTQUE
      IMPLICIT NONE
      INTEGER N, MAXT
      PARAMETER (N = 200, MAXT = 2500)
      INTEGER H(4), IERR, ITET(4, MAXT), IN(N), IN2(N), I, K, L, IV
      DOUBLE PRECISION XYZ(3, N), P(3, N), W(4, N), S
      LOGICAL YES
      SAVE
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      CALL GOOD(H, IERR, 'MGINS')
      CALL MGTETS(H, MAXT, ITET, IERR)
      DO 20 I = 1, N
        DO 10 K = 1, 3
          P(K, I) = 0.45D0*(XYZ(K, I) + XYZ(K, N + 1 - I)) + 0.05123D0
   10   CONTINUE
   20 CONTINUE
      P(1, N) = 7
      CALL MGLOCW(H, N, P, IN, W, IERR)
      CALL GOOD(H, IERR, 'MGLOCW')
      CALL MGLOCN(H, N, P, IN2, IERR)
      CALL GOOD(H, IERR, 'MGLOCN')
      YES = IN(N) .EQ. 0 .AND. W(1, N) .EQ. 0
      DO 50 I = 1, N
        YES = YES .AND. IN2(I) .EQ. IN(I)
        CALL MGLOC(H, P(1, I), L, IERR)
        YES = YES .AND. IERR .EQ. 0 .AND. L .EQ. IN(I)
        IF (I .EQ. N) GO TO 50
        YES = YES .AND. IN(I) .GT. 0
        DO 40 K = 1, 3
          S = -P(K, I)
          DO 30 L = 1, 4
            S = S + W(L, I)*XYZ(K, ITET(L, IN(I)))
   30     CONTINUE
          YES = YES .AND. ABS(S) .LT. 1D-12
   40   CONTINUE
   50 CONTINUE
      CALL EXPECT(YES, 'location and weights')
      YES = .TRUE.
      DO 60 I = 1, N - 1
        CALL MGNEAR(H, XYZ(1, I), IV, IERR)
        YES = YES .AND. IERR .EQ. 0 .AND. XYZ(1, IV) .EQ. XYZ(1, I)
     &        .AND. XYZ(2, IV) .EQ. XYZ(2, I) .AND. IV .LE. I
   60 CONTINUE
      CALL EXPECT(YES, 'MGNEAR')
      CALL MGNEAN(H, N - 1, XYZ, IN2, IERR)
      CALL GOOD(H, IERR, 'MGNEAN')
      DO 70 I = 1, N - 1
        CALL MGNEAR(H, XYZ(1, I), IV, IERR)
        YES = YES .AND. IN2(I) .EQ. IV
   70 CONTINUE
      CALL EXPECT(YES, 'nearest vertices')
      CALL MGSEG(H, XYZ(1, 1), XYZ(1, N - 1), N, IN2, W, L, IERR)
      CALL GOOD(H, IERR, 'MGSEG')
      YES = .FALSE.
      DO 80 I = 1, 4
        YES = YES .OR. ITET(I, IN2(1)) .EQ. 1
   80 CONTINUE
      CALL EXPECT(YES .AND. L .GT. 1 .AND. W(1, 1) .EQ. 0, 'a segment')
      CALL MGSEG(H, XYZ(1, 1), XYZ(1, N - 1), 0, IN2, W, I, IERR)
      CALL BAD(H, IERR, MGEBUF, 'needed')
      CALL EXPECT(I .EQ. L, 'the room that a segment needs')
      CALL MGFREE(H, IERR)
      END

! Points leave, move and get other numbers: the same as without.
      SUBROUTINE TSTCHG
      IMPLICIT NONE
      INTEGER N, MAXT
      PARAMETER (N = 200, MAXT = 1000)
      INTEGER H(4), G(4), IERR, IP(N), INEW(N), I, K, NT, MT
      INTEGER IH(4, MAXT), IG(4, MAXT)
      DOUBLE PRECISION XYZ(3, N), P(3, N)
      LOGICAL YES
      CALL MKPTS(N, XYZ)
      DO 20 I = 1, N
        DO 10 K = 1, 3
          P(K, I) = XYZ(K, I)
          IF (I .GT. 50 .AND. I .LE. 100) P(K, I) = 0.5D0*XYZ(K, I)
   10   CONTINUE
   20 CONTINUE
      CALL MGNEW(H, IERR)
      CALL MGCANO(H, 1, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      DO 30 I = 1, 50
        IP(I) = 50 + I
   30 CONTINUE
      CALL MGMOV(H, 50, IP, P(1, 51), IERR)
      CALL GOOD(H, IERR, 'MGMOV')
      DO 40 I = 1, 100
        IP(I) = 100 + I
   40 CONTINUE
      CALL MGREM(H, 100, IP, IERR)
      CALL GOOD(H, IERR, 'MGREM')
      CALL MGMOVA(H, N, P, IERR)
      CALL GOOD(H, IERR, 'MGMOVA')
      CALL MGRNUM(H, N, INEW, IERR)
      CALL GOOD(H, IERR, 'MGRNUM')
      YES = .TRUE.
      DO 50 I = 1, N
        IF (I .LE. 100) YES = YES .AND. INEW(I) .EQ. I
        IF (I .GT. 100) YES = YES .AND. INEW(I) .EQ. 0
   50 CONTINUE
      CALL EXPECT(YES, 'new numbers')
      CALL MGCHK(H, 3, IERR)
      CALL GOOD(H, IERR, 'MGCHK after changes')
      CALL MGNEW(G, IERR)
      CALL MGCANO(G, 1, IERR)
      CALL MGINS(G, 100, P, IERR)
      CALL MGTETS(H, MAXT, IH, IERR)
      CALL MGTETS(G, MAXT, IG, IERR)
      CALL MGNTET(H, NT, IERR)
      CALL MGNTET(G, MT, IERR)
      YES = NT .EQ. MT
      DO 70 I = 1, MIN(NT, MT)
        DO 60 K = 1, 4
          YES = YES .AND. IH(K, I) .EQ. IG(K, I)
   60   CONTINUE
   70 CONTINUE
      CALL EXPECT(YES, 'tetrahedra after changes')
      IP(1) = 101
      CALL MGREM(H, 1, IP, IERR)
      CALL BAD(H, IERR, 11, 'there is no point 101: 100 were given')
      CALL MGMOV(H, 1, IP, P, IERR)
      CALL BAD(H, IERR, 11, 'there is no point 101')
      CALL MGMOVA(H, 99, P, IERR)
      CALL BAD(H, IERR, 11, '99 places')
      CALL MGRNUM(H, 99, INEW, IERR)
      CALL BAD(H, IERR, 20, 'new_index')
      CALL MGFREE(H, IERR)
      CALL MGFREE(G, IERR)
      END

! Settings do not change the tetrahedra.
      SUBROUTINE TSTSET
      IMPLICIT NONE
      INTEGER N, MAXT
      PARAMETER (N = 200, MAXT = 2500)
      INTEGER H(4), IERR, ITET(4, MAXT), IWANT(4, MAXT), NT, I, K, IORD
      INTEGER L
      DOUBLE PRECISION XYZ(3, N), V
      CHARACTER*20 NAME
      LOGICAL YES
      SAVE
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      CALL MGCANO(H, 1, IERR)
      CALL GOOD(H, IERR, 'MGCANO')
      CALL MGINS(H, N, XYZ, IERR)
      CALL MGNTET(H, NT, IERR)
      CALL MGTETS(H, MAXT, IWANT, IERR)
      CALL MGPAR(H, MGPPPC, 4D0, IERR)
      CALL GOOD(H, IERR, 'MGPAR')
      CALL MGSEED(H, 7, IERR)
      CALL GOOD(H, IERR, 'MGSEED')
      CALL MGTHR(H, 2, IERR)
      CALL GOOD(H, IERR, 'MGTHR')
      CALL MGMEM(H, 1D10, IERR)
      CALL GOOD(H, IERR, 'MGMEM')
      CALL MGCOMP(H, 1, IERR)
      CALL GOOD(H, IERR, 'MGCOMP')
      CALL MGRDPR(H, 1, IERR)
      CALL GOOD(H, IERR, 'MGRDPR')
      CALL MGPAR(H, MGPSEP, DBLE(MGSROU), IERR)
      CALL GOOD(H, IERR, 'MGPAR of rounds')
      CALL MGGPAR(H, MGPPPC, V, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. V .EQ. 4D0, 'MGGPAR')
      CALL MGGPAR(H, MGPSEP, V, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NINT(V) .EQ. MGSROU, 'rounds')
      CALL MGGPAR(H, 11, V, IERR)
      CALL BAD(H, IERR, MGEKEY, 'order parameter 11')
      CALL MGGSED(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 7, 'MGGSED')
      CALL MGGTHR(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 2, 'MGGTHR')
      CALL MGGMEM(H, V, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. V .EQ. 1D10, 'MGGMEM')
      CALL MGGCOM(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 1, 'MGGCOM')
      CALL MGGRDP(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 1, 'MGGRDP')
      CALL MGGCAN(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 1, 'MGGCAN')
      CALL MGGBAS(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. 1, 'MGGBAS')
      CALL MGORDN(H, MGOBRI, IERR)
      CALL MGGORD(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. MGOBRI, 'MGGORD')
      CALL MGSHRK(H, IERR)
      CALL GOOD(H, IERR, 'MGSHRK')
      CALL MGISA(H, 'baseline', IERR)
      CALL GOOD(H, IERR, 'MGISA')
      CALL MGISAN(H, NAME, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NAME .EQ. 'baseline', 'MGISAN')
      CALL MGISA(H, ' ', IERR)
      CALL GOOD(H, IERR, 'MGISA of the best')
      YES = .TRUE.
      DO 30 L = 1, 1000
        CALL MGSAT(L, IORD, IERR)
        IF (IERR .NE. 0) GOTO 35
        CALL MGSNAM(IORD, NAME, IERR)
        YES = YES .AND. IERR .EQ. 0
        CALL MGORD(H, NAME, IERR)
        YES = YES .AND. IERR .EQ. 0
        CALL MGCLR(H, IERR)
        CALL MGINS(H, N/2, XYZ, IERR)
        CALL MGORDN(H, IORD, IERR)
        YES = YES .AND. IERR .EQ. 0
        CALL MGINS(H, N - N/2, XYZ(1, N/2 + 1), IERR)
        CALL MGTETS(H, MAXT, ITET, IERR)
        DO 20 I = 1, NT
          DO 10 K = 1, 4
            YES = YES .AND. ITET(K, I) .EQ. IWANT(K, I)
   10     CONTINUE
   20   CONTINUE
   30 CONTINUE
   35 CALL EXPECT(YES .AND. L .GT. 10, 'order schemes')
      CALL MGSTAT(H, MGFPTS, V, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NINT(V) .GT. 190, 'MGSTAT')
      CALL MGMEM(H, 1D5, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      CALL BAD(H, IERR, MGEMEM, 'memory')
      CALL MGMEM(H, 0D0, IERR)
      CALL MGCHK(H, MGCCAN, IERR)
      CALL GOOD(H, IERR, 'valid after running out of memory')
      CALL MGFREE(H, IERR)
      END

! Names and texts.
      SUBROUTINE TSTTXT
      IMPLICIT NONE
      INTEGER IERR, IABI, IORD, H(4)
      CHARACTER*60 TEXT
      CHARACTER*4 SHORT
      INCLUDE 'mgdt_f77.inc'
      CALL MGVERS(TEXT, IABI, IERR)
      CALL EXPECT(TEXT .EQ. '1.4.0' .AND. IABI .EQ. 1, 'MGVERS')
      CALL MGSTNM(MGFWST, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. TEXT .EQ. 'walk steps', 'MGSTNM')
      CALL MGSTNM(MGFWST, SHORT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. SHORT .EQ. 'walk', 'a name cut')
      CALL MGSTNM(-1, TEXT, IERR)
      CALL EXPECT(IERR .EQ. MGEKEY, 'the name of no figure')
      IORD = 77
      CALL MGSNUM('multi-grid ', IORD, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. IORD .EQ. MGOMUL, 'MGSNUM')
      CALL MGSNUM('multigrid', IORD, IERR)
      CALL EXPECT(IERR .EQ. MGESCH .AND. IORD .EQ. MGOMUL, 'no scheme')
      CALL MGSAT(1, IORD, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. IORD .EQ. MGOAUT, 'MGSAT')
      CALL MGSAT(10, IORD, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. IORD .EQ. MGOMUL, 'MGSAT, last')
      CALL MGSAT(11, IORD, IERR)
      CALL EXPECT(IERR .EQ. MGESCH .AND. IORD .EQ. MGOMUL, 'beyond')
      CALL MGSAT(0, IORD, IERR)
      CALL EXPECT(IERR .EQ. MGESCH .AND. IORD .EQ. MGOMUL, 'before')
      TEXT = 'as it was'
      CALL MGSNAM(5, TEXT, IERR)
      CALL EXPECT(IERR .EQ. MGESCH .AND. TEXT .EQ. 'as it was',
     &            'the name of no scheme')
      CALL MGTEXT(MGEFIN, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. TEXT .NE. ' ', 'MGTEXT')
      CALL MGTEXT(9999, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. TEXT .NE. ' ', 'unknown status')
      CALL MGNEW(H, IERR)
      CALL MGERR(H, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. TEXT .EQ. ' ', 'no message yet')
      CALL MGFREE(H, IERR)
      END

! A Voronoi diagram in a box.
      SUBROUTINE TSTVOR
      IMPLICIT NONE
      INTEGER N, MAXF, MAXC
      PARAMETER (N = 300, MAXF = 4000, MAXC = 30000)
      INTEGER H(4), HV(4), IERR, NF, NC, NV, I, K, J
      INTEGER IOFF(MAXF), ICOR(MAXC), ISID(2, MAXF)
      DOUBLE PRECISION XYZ(3, N), BOX(4, 6), CELL(N), AT(3, MAXC)
      DOUBLE PRECISION D, E, V
      CHARACTER*256 TEXT
      LOGICAL YES
      SAVE XYZ, CELL, AT, IOFF, ICOR, ISID
      INCLUDE 'mgdt_f77.inc'
      DATA BOX /-1D0, 0D0, 0D0, 9D0, 1D0, 0D0, 0D0, 9D0,
     &          0D0, -1D0, 0D0, 9D0, 0D0, 1D0, 0D0, 9D0,
     &          0D0, 0D0, -1D0, 9D0, 0D0, 0D0, 1D0, 9D0/
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      CALL MGYNEW(H, 6, BOX, HV, IERR)
      CALL GOOD(H, IERR, 'MGYNEW')
      CALL MGYDBL(HV, MGYCVO, N, CELL, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGYDBL')
      V = 0
      DO 10 I = 1, N
        V = V + CELL(I)
   10 CONTINUE
      CALL EXPECT(ABS(V - 18D0**3) .LT. 1D-9, 'cells fill the box')
      CALL MGYSIZ(HV, MGYFAR, NF, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NF .GT. N, 'MGYSIZ')
      CALL MGYNUM(HV, MGYNFA, NC, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NC .EQ. NF, 'MGYNUM')
      CALL MGYINF(MGYFSI, NC, NV, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NC .EQ. 2 .AND. NV .EQ. 0,
     &            'MGYINF')
      CALL MGYSIZ(HV, MGYFCO, NC, IERR)
      CALL MGYSIZ(HV, MGYVTX, NV, IERR)
      CALL EXPECT(NC .LE. MAXC .AND. NF .LT. MAXF, 'room')
      CALL MGYARR(HV, MGYFOF, NF + 1, IOFF, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. IOFF(NF + 1) .EQ. NC + 1, 'MGYARR')
      CALL MGYARR(HV, MGYFCO, NC, ICOR, IERR)
      CALL MGYARR(HV, MGYFSI, 2*NF, ISID, IERR)
      CALL MGYDBL(HV, MGYVTX, NV, AT, IERR)
      CALL EXPECT(IERR .EQ. 0, 'vertices')
      YES = .TRUE.
      DO 40 I = 1, NF
        DO 30 K = IOFF(I), IOFF(I + 1) - 1
          D = 0
          E = 0
          IF (ISID(2, I) .LT. 0) GO TO 30
          DO 20 J = 1, 3
            D = D + (AT(J, ICOR(K)) - XYZ(J, ISID(1, I)))**2
            E = E + (AT(J, ICOR(K)) - XYZ(J, ISID(2, I)))**2
   20     CONTINUE
          YES = YES .AND. ABS(D - E) .LE. 1D-12*(1 + D)
   30   CONTINUE
   40 CONTINUE
      CALL EXPECT(YES, 'corners are as far from both points')
! What is refused, and what is dropped.
      CALL MGYDBL(HV, MGYVTX, NV - 1, AT, IERR)
      CALL EXPECT(IERR .EQ. MGEBUF, 'no room')
      CALL MGYERR(HV, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. INDEX(TEXT, 'needed') .GT. 0,
     &            'MGYERR')
      CALL MGYARR(HV, MGYVTX, NV, ICOR, IERR)
      CALL EXPECT(IERR .EQ. MGEKEY, 'no integers')
      CALL MGYDRP(HV, 1D-3, 0D0, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGYDRP')
      CALL MGYSIZ(HV, MGYFAR, NC, IERR)
      CALL EXPECT(NC .LT. NF .AND. NC .GT. 0, 'small faces')
      CALL MGYDRP(HV, -1D0, 0D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'a negative area')
      CALL MGYSIZ(H, MGYFAR, NC, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'a handle of another kind')
      CALL MGNPT(HV, NC, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'no triangulation')
      CALL MGYFRE(HV, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGYFRE')
      CALL MGYFRE(HV, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'freed')
      CALL MGYERR(HV, TEXT, IERR)
      CALL EXPECT(IERR .EQ. MGENUL .AND. TEXT .EQ. ' ', 'no diagram')
      CALL MGYNEW(H, 5, BOX, HV, IERR)
      CALL BAD(H, IERR, MGEARG, 'no end')
      CALL MGYSIZ(HV, MGYFAR, NC, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'empty after a failure')
      CALL MGFREE(H, IERR)
      END

! A domain: two cubes that share a square, as squares and as triangles.
      SUBROUTINE TSTDOM
      IMPLICIT NONE
      INTEGER MAXT
      PARAMETER (MAXT = 40)
      INTEGER HD(4), HG(4), HX(4), IERR, N, I, J, K, NT, NF, IC(6, 2)
      INTEGER IQ(4, 11), ITRI(3, 22), IOFF(12), MARK(22), ISEG(2, 2)
      INTEGER ITET(4, MAXT), IREG(MAXT), MREG(2), IFAC(3, MAXT)
      INTEGER IPAI(4), NHEARD, NCOL, IREAL, MREGS(2), IORI(12)
      DOUBLE PRECISION VOLS(MAXT)
      DOUBLE PRECISION XYZ(3, 12), P(3, 2), GOT(3, 12), V(9), VOL
      DOUBLE PRECISION CROSS(3, 6), BYTES
      INTEGER HM(4), ITM(4, 2), ITP(2), IANG(18), IBEL(6)
      DOUBLE PRECISION WP(8)
      DOUBLE PRECISION PM(3, 5), SHAPES(6), SIZES(5)
      CHARACTER*256 TEXT
      LOGICAL YES
      EXTERNAL DOMPRO, DOMSTP, DOMSIZ
      COMMON /DOMCOM/ NHEARD
      INCLUDE 'mgdt_f77.inc'
      DATA XYZ /0, 0, 0, 2, 0, 0, 2, 2, 0, 0, 2, 0,
     &          0, 0, 2, 2, 0, 2, 2, 2, 2, 0, 2, 2,
     &          0, 0, 4, 2, 0, 4, 2, 2, 4, 0, 2, 4/
      DATA IQ /1, 4, 3, 2, 1, 2, 6, 5, 2, 3, 7, 6, 3, 4, 8, 7,
     &         4, 1, 5, 8, 5, 6, 7, 8, 5, 6, 10, 9, 6, 7, 11, 10,
     &         7, 8, 12, 11, 8, 5, 9, 12, 9, 10, 11, 12/
      DATA CROSS /0, 0, 0, 4, 0, 0, 0, 4, 0,
     &            1, 1, -1, 1, 1, 2, 5, 1, 1/
      DATA IC /1, 2, 3, 4, 5, 6, 1, 2, 3, 4, 5, 7/
      DATA ISEG /1, 2, 9, 10/
      DATA PM /0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1/
      DATA ITM /1, 2, 3, 4, 2, 3, 4, 5/
      DATA SIZES /0.5, 0.6, 0.7, 0.8, 0.9/
      CALL MGDNEW(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDNEW')
      CALL MGDGOP(HD, MGDBAS, I, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. I .EQ. 1, 'MGDGOP')
      CALL MGDOPT(HD, MGDTHR, 2, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDOPT')
      CALL MGDOPT(HD, MGDTHR, -2, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative threads')
      CALL MGDERR(HD, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. INDEX(TEXT, '-2') .GT. 0, 'MGDERR')
      CALL MGDMEM(HD, 5D9, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDMEM')
      CALL MGDGME(HD, BYTES, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. BYTES .EQ. 5D9, 'MGDGME')
      CALL MGDMEM(HD, -1D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative limit')
      CALL MGDINP(HD, 12, XYZ, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDINP')
      DO 10 I = 1, 11
        IOFF(I) = 1 + 4*(I - 1)
        MARK(I) = I
   10 CONTINUE
      IOFF(12) = 45
      CALL MGDPOL(HD, 11, IOFF, IQ, MARK, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDPOL')
      CALL MGDSEG(HD, 2, ISEG, MARK, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDSEG')
      DO 15 I = 1, 2
        P(1, I) = 1
        P(2, I) = 1
        P(3, I) = 2*I - 1
        MREGS(I) = 5 + 2*I
   15 CONTINUE
      CALL MGDREG(HD, 2, P, MREGS, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDREG')
      CALL MGDOPR(HD, MGDWLD, 1D-9, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDOPR')
      CALL MGDGOR(HD, MGDWLD, BYTES, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. BYTES .EQ. 1D-9, 'MGDGOR')
      CALL MGDOPR(HD, MGDFLT, 1D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'too large a distance')
      CALL MGDCLN(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDCLN')
      CALL MGDNUM(HD, MGDNMP, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 0, 'nothing is welded')
      CALL MGDDBL(HD, MGDPTS, 36, GOT, IERR)
      YES = IERR .EQ. 0
      DO 16 I = 1, 12
        DO 17 K = 1, 3
          YES = YES .AND. GOT(K, I) .EQ. XYZ(K, I)
   17   CONTINUE
   16 CONTINUE
      CALL EXPECT(YES, 'MGDDBL')
      CALL MGDVAL(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDVAL')
      NHEARD = 0
      CALL MGDPRG(HD, DOMPRO, IERR)
      CALL MGDBLD(HD, HG, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NHEARD .GT. 0, 'MGDBLD')
      CALL MGDNPR(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDNPR')
      CALL MGDCHK(HD, HG, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDCHK')
      CALL MGUPRG(HG, DOMPRO, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUPRG')
      CALL MGUCHK(HG, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUCHK')
      CALL MGUNPR(HG, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUNPR')
      CALL MGUOPT(HG, MGUTHR, 2, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUOPT')
      CALL MGUGOP(HG, MGUTHR, I, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. I .EQ. 2, 'MGUGOP')
      CALL MGUMEM(HG, 6D9, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUMEM')
      CALL MGUGME(HG, BYTES, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. BYTES .EQ. 6D9, 'MGUGME')
      CALL MGUMEM(HG, -1D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative limit')
      CALL MGUNUM(HG, MGUNTE, NT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NT .LE. MAXT, 'MGUNUM')
      CALL MGUINF(MGUPTS, NCOL, IREAL, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NCOL .EQ. 3 .AND. IREAL .EQ. 1,
     &            'MGUINF')
      CALL MGDINF(MGDPAI, NCOL, IREAL, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NCOL .EQ. 4 .AND. IREAL .EQ. 0,
     &            'MGDINF')
      CALL MGUINF(MGUNTE, NCOL, IREAL, IERR)
      CALL EXPECT(IERR .EQ. MGEKEY .AND. NCOL .EQ. 4, 'no array')
      CALL MGUMSR(HG, MGTVOL, MAXT, VOLS, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUMSR')
      CALL MGUARR(HG, MGUORI, 12, IORI, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. IORI(1) .EQ. 1 .AND.
     &            IORI(12) .EQ. 12, 'origins')
      CALL MGUARR(HG, MGUTET, 4*MAXT, ITET, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUARR')
      CALL MGUARR(HG, MGUREG, MAXT, IREG, IERR)
      CALL MGUARR(HG, MGURMA, 2, MREG, IERR)
      CALL MGUDBL(HG, MGUPTS, 36, GOT, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUDBL')
      V(5) = 0
      V(7) = 0
      V(9) = 0
      DO 20 I = 1, NT
        K = MREG(IREG(I))
        V(5) = V(5) + VOLS(I)
        V(K) = V(K) + VOL(GOT(1, ITET(1, I)), GOT(1, ITET(2, I)),
     &                    GOT(1, ITET(3, I)), GOT(1, ITET(4, I)))/6
   20 CONTINUE
      CALL EXPECT(ABS(V(7) - 8) .LT. 1D-12, 'volume of a cube')
      CALL EXPECT(ABS(V(9) - 8) .LT. 1D-12, 'volume of the other')
      CALL EXPECT(ABS(V(5) - 16) .LT. 1D-12, 'both volumes')
! The diagonals of squares that were chosen make triangles.
      CALL MGUSIZ(HG, MGUFAC, NF, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NF .EQ. 66, 'MGUSIZ')
      CALL MGUARR(HG, MGUFAC, 3*MAXT, IFAC, IERR)
      CALL MGUARR(HG, MGUFMA, 22, MARK, IERR)
      DO 40 I = 1, 22
        DO 30 J = 1, 3
          ITRI(J, I) = IFAC(J, I)
   30   CONTINUE
   40 CONTINUE
      CALL MGDTRI(HD, 22, ITRI, MARK, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDTRI')
      CALL MGDHOL(HD, 1, P, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDHOL')
      CALL MGDCHK(HD, HG, IERR)
      CALL EXPECT(IERR .EQ. MGECHK, 'a mesh in a hole')
      CALL MGDPRG(HD, DOMSTP, IERR)
      CALL MGDBLD(HD, HX, IERR)
      CALL EXPECT(IERR .EQ. MGECAN, 'stopped by progress')
      CALL MGUCHK(HX, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'no mesh')
      CALL MGDNPR(HD, IERR)
      CALL MGDCAN(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDCAN')
      CALL MGDBLD(HD, HX, IERR)
      CALL EXPECT(IERR .EQ. MGECAN, 'stopped by MGDCAN')
      CALL MGDBLD(HD, HX, IERR)
      CALL EXPECT(IERR .EQ. 0, 'built')
      CALL MGUNUM(HX, MGUNTE, N, IERR)
      CALL EXPECT(N .GT. 0 .AND. N .LT. NT, 'a cube is a hole')
! A mesh of two tetrahedra that the caller has.
      CALL MGUNEW(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUNEW')
      CALL MGUINP(HM, 5, PM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUINP')
      CALL MGUINT(HM, 2, ITM, MARK, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUINT')
      CALL MGUTRI(HM, 1, ITM(2, 1), MARK(3), IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUTRI')
      CALL MGUSEG(HM, 1, ITM(3, 1), MARK(4), IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUSEG')
      CALL MGUINX(HM, 1, ITM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUINX')
      CALL MGUBLD(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUBLD')
      CALL MGUBLD(HM, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'nothing to build')
      CALL MGUOPR(HM, MGUSZE, 0.5D0, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUOPR')
      CALL MGUGOR(HM, MGUSZE, WP(1), IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. ABS(WP(1) - 0.5D0) .LE. 0,
     &            'MGUGOR')
      WP(2) = 1D0
      CALL MGUSSZ(HM, MGUSRE, 2, WP, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUSSZ')
      CALL MGUSFL(HM, 5, PM, SIZES, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUSFL')
      CALL MGUSFN(HM, DOMSIZ, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUSFN')
      NHEARD = 0
      CALL MGURFN(HM, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NHEARD .GT. 0, 'MGURFN')
      NHEARD = -1
      CALL MGURFN(HM, IERR)
      CALL EXPECT(IERR .EQ. MGECAN, 'a subroutine that stops')
      CALL MGUSNO(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUSNO')
      CALL MGUSFL(HM, 0, PM, SIZES, IERR)
      CALL EXPECT(IERR .EQ. 0, 'no field')
      CALL MGUNUM(HM, MGUNIN, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .GE. 0, 'MGUNIN')
      CALL MGUOPT(HM, MGUGOA, 50, IERR)
      CALL EXPECT(IERR .EQ. 0, 'a goal')
      CALL MGUIMP(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUIMP')
      CALL MGUCHK(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'the improved mesh')
      CALL MGUNUM(HM, MGUNRG, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 2, 'two regions')
      CALL MGULOC(HM, MGXBOU, 2, PM(1, 4), ITP, WP, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. ITP(1) .GE. 1 .AND.
     &            ABS(WP(1) + WP(2) + WP(3) + WP(4) - 1) .LT. 1D-12,
     &            'MGULOC')
      CALL MGULOC(HM, MGXNEA, 2, PM, ITP, WP, IERR)
      CALL EXPECT(IERR .EQ. MGEKEY, 'not of meshes')
      CALL MGUVAL(HM, MGXNON, 3, PM, 2, PM(1, 4), WP, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. ABS(WP(4) - 1) .LT. 1D-12,
     &            'MGUVAL')
      CALL MGUSUM(HM, SHAPES, IANG, IBEL, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. SHAPES(1) .GT. 0 .AND.
     &            IANG(1) .EQ. 0 .AND. IBEL(1) .EQ. 0, 'MGUSUM')
      CALL MGUDBL(HM, MGUSHA, 6, SHAPES, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. SHAPES(2) .GE. SHAPES(1),
     &            'angles before and after')
      CALL MGUFRE(HM, IERR)
      CALL EXPECT(IERR .EQ. 0, 'the mesh is freed')
      CALL MGUNUM(HX, MGUNTE, N, IERR)
! What is refused.
      CALL MGUARR(HX, MGUTET, 4*N - 1, ITET, IERR)
      CALL EXPECT(IERR .EQ. MGEBUF, 'no room')
      CALL MGUERR(HX, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. INDEX(TEXT, 'needed') .GT. 0,
     &            'MGUERR')
      CALL MGUCAN(HX, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUCAN')
      CALL MGUFRE(HX, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUFRE')
      CALL MGDNUM(HD, 999, N, IERR)
      CALL EXPECT(IERR .EQ. MGEKEY, 'an unknown number')
      CALL MGDINP(HD, 6, CROSS, IERR)
      CALL MGDTRI(HD, 2, IC, MARK, IERR)
      CALL MGDVAL(HD, IERR)
      CALL EXPECT(IERR .EQ. MGEBND, 'triangles that cross')
      CALL MGDARR(HD, MGDPAI, 4, IPAI, IERR)
      YES = IERR .EQ. 0 .AND. IPAI(1) .EQ. MGDKFA .AND. IPAI(2) .EQ. 1
      YES = YES .AND. IPAI(3) .EQ. MGDKFA .AND. IPAI(4) .EQ. 2
      CALL EXPECT(YES, 'the pair')
      CALL MGDSIZ(HD, MGDPAI, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 4, 'MGDSIZ')
      CALL MGDNUM(HD, MGDNPA, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 1, 'MGDNUM')
      CALL MGDTRI(HD, 2, IC(1, 2), MARK, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'a corner that is no point')
      CALL MGDTRI(HD, -1, IC, MARK, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative triangles')
      CALL MGDPOL(HD, 0, IOFF, IQ, MARK, IERR)
      CALL EXPECT(IERR .EQ. 0, 'no polygons')
      CALL MGDCLR(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDCLR')
      CALL MGDNUM(HD, MGDNPT, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 0, 'no points')
      CALL MGNPT(HD, N, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'no triangulation')
! A handle of another kind is not emptied.
      CALL MGFREE(HD, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGFREE of a domain')
      CALL MGYFRE(HD, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGYFRE of a domain')
      CALL MGBFRE(HD, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGBFRE of a domain')
      CALL MGUFRE(HD, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGUFRE of a domain')
      CALL MGDFRE(HG, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'MGDFRE of a mesh')
      CALL MGDFRE(HD, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGDFRE')
! The mesh outlives the domain.
      CALL MGUCHK(HG, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUCHK without a domain')
      CALL MGUFRE(HG, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGUFRE')
      CALL MGDFRE(HD, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'freed')
      CALL MGDERR(HD, TEXT, IERR)
      CALL EXPECT(IERR .EQ. MGENUL .AND. TEXT .EQ. ' ', 'no domain')
      END

! Points in a periodic box.
      SUBROUTINE TSTBOX
      IMPLICIT NONE
      INTEGER MAXT
      PARAMETER (MAXT = 400)
      INTEGER HB(4), HV(4), IERR, N, I, J, K, L, NT, NE, NF, IPT(2)
      INTEGER ITET(4, MAXT), IOFF(3, 4, MAXT), NHEARD
      DOUBLE PRECISION VEC(3, 3), XYZ(3, 40), GOT(3, 40), X(40), SUM
      DOUBLE PRECISION C(3, 4), VOL, DIST, BYTES
      CHARACTER*256 TEXT
      EXTERNAL DOMPRO, DOMSTP
      COMMON /DOMCOM/ NHEARD
      INCLUDE 'mgdt_f77.inc'
      DATA VEC /1, 0, 0, 0.5, 1, 0, 0, 0, 1/
      CALL MKPTS(40, XYZ)
      CALL MGBNEW(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBNEW')
      CALL MGBSVC(HB, 4, VEC, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'four vectors')
      CALL MGBSVC(HB, 3, VEC, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBSVC')
      CALL MGBGOP(HB, MGBBAS, I, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. I .EQ. 1, 'MGBGOP')
      CALL MGBMRG(HB, 1D-9, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBMRG')
      CALL MGBGMR(HB, DIST, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. DIST .EQ. 1D-9, 'MGBGMR')
      CALL MGBOPT(HB, MGBTHR, 2, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBOPT')
      CALL MGBOPT(HB, MGBTHR, -2, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative threads')
      CALL MGBERR(HB, TEXT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. INDEX(TEXT, '-2') .GT. 0, 'MGBERR')
      CALL MGBMEM(HB, 7D9, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBMEM')
      CALL MGBGME(HB, BYTES, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. BYTES .EQ. 7D9, 'MGBGME')
      CALL MGBMEM(HB, -1D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative limit')
      CALL MGBINS(HB, 40, XYZ, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBINS')
      NHEARD = 0
      CALL MGBPRG(HB, DOMPRO, IERR)
      CALL MGBBLD(HB, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NHEARD .GT. 0, 'MGBBLD')
      CALL MGBNPR(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBNPR')
      CALL MGBCHK(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBCHK')
      CALL MGBNUM(HB, MGBNTE, NT, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. NT .LE. MAXT, 'MGBNUM')
      CALL MGBARR(HB, MGBTET, 4*MAXT, ITET, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBARR')
      CALL MGBARR(HB, MGBTSH, 12*MAXT, IOFF, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBARR of offsets')
      CALL MGBDBL(HB, MGBPTS, 120, GOT, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBDBL')
      SUM = 0
      DO 40 I = 1, NT
        DO 30 K = 1, 4
          DO 20 J = 1, 3
            C(J, K) = GOT(J, ITET(K, I))
            DO 10 L = 1, 3
              C(J, K) = C(J, K) + IOFF(L, K, I)*VEC(J, L)
   10       CONTINUE
   20     CONTINUE
   30   CONTINUE
        SUM = SUM + VOL(C(1, 1), C(1, 2), C(1, 3), C(1, 4))/6
   40 CONTINUE
      CALL EXPECT(ABS(SUM - 1) .LT. 1D-12, 'volume of the box')
      CALL MGBNUM(HB, MGBNVE, N, IERR)
      CALL MGBNUM(HB, MGBNED, NE, IERR)
      CALL EXPECT(NE .EQ. N + NT, 'edges')
      CALL MGBSIZ(HB, MGBVNB, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 2*NE, 'MGBSIZ')
      CALL MGBCEL(HB, MGMVOL, 40, X, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBCEL')
      SUM = 0
      DO 50 I = 1, 40
        SUM = SUM + X(I)
   50 CONTINUE
      CALL EXPECT(ABS(SUM - 1) .LT. 1D-12, 'volumes of cells')
      CALL MGBVOR(HB, HV, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBVOR')
      CALL MGYSIZ(HV, MGYFAR, NF, IERR)
      CALL MGYSIZ(HV, MGYFSH, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 3*NF, 'MGYFSH')
      CALL MGBINF(MGBTSH, N, NF, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. 12 .AND. NF .EQ. 0,
     &            'MGBINF')
      CALL MGYFRE(HV, IERR)
! Points move by a vector, and two change places.
      DO 60 I = 1, 40
        XYZ(1, I) = XYZ(1, I) + 2
   60 CONTINUE
      CALL MGBMVA(HB, 40, XYZ, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBMVA')
      IPT(1) = 2
      IPT(2) = 1
      CALL MGBMOV(HB, 2, IPT, XYZ, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBMOV')
      IPT(2) = 41
      CALL MGBMOV(HB, 2, IPT, XYZ, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'no such point')
      CALL MGBMOV(HB, -1, IPT, XYZ, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'negative points')
      CALL MGBPRG(HB, DOMSTP, IERR)
      CALL MGBBLD(HB, IERR)
      CALL EXPECT(IERR .EQ. MGECAN, 'stopped by progress')
      CALL MGBNPR(HB, IERR)
      CALL MGBCAN(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBCAN')
      CALL MGBBLD(HB, IERR)
      CALL EXPECT(IERR .EQ. MGECAN, 'stopped by MGBCAN')
      CALL MGBBLD(HB, IERR)
      CALL MGBNUM(HB, MGBNTE, N, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. N .EQ. NT, 'as many tetrahedra')
      CALL MGBCLR(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBCLR')
      CALL MGDNUM(HB, MGDNPT, N, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'no domain')
      CALL MGBFRE(HB, IERR)
      CALL EXPECT(IERR .EQ. 0, 'MGBFRE')
      CALL MGBFRE(HB, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'freed')
      END

      SUBROUTINE DOMPRO(FRAC, ICANC)
      IMPLICIT NONE
      DOUBLE PRECISION FRAC
      INTEGER ICANC, NHEARD
      COMMON /DOMCOM/ NHEARD
      NHEARD = NHEARD + 1
      IF (FRAC .GT. 1D0) ICANC = 1
      END

! Sizes at places; stops if NHEARD is negative.
      SUBROUTINE DOMSIZ(N, XYZ, SIZES, ICANC)
      IMPLICIT NONE
      INTEGER N, ICANC, I, NHEARD
      DOUBLE PRECISION XYZ(3, N), SIZES(N)
      COMMON /DOMCOM/ NHEARD
      IF (NHEARD .LT. 0) ICANC = 1
      NHEARD = NHEARD + 1
      DO 10 I = 1, N
        SIZES(I) = 0.5D0 + 0.1D0*ABS(XYZ(3, I))
   10 CONTINUE
      END

      SUBROUTINE DOMSTP(FRAC, ICANC)
      IMPLICIT NONE
      DOUBLE PRECISION FRAC
      INTEGER ICANC
      IF (FRAC .GE. 0D0) ICANC = 1
      END

! Six times the volume of a tetrahedron.
      DOUBLE PRECISION FUNCTION VOL(A, B, C, D)
      IMPLICIT NONE
      DOUBLE PRECISION A(3), B(3), C(3), D(3), X, Y, Z
      X = (B(2) - A(2))*(C(3) - A(3)) - (B(3) - A(3))*(C(2) - A(2))
      Y = (B(3) - A(3))*(C(1) - A(1)) - (B(1) - A(1))*(C(3) - A(3))
      Z = (B(1) - A(1))*(C(2) - A(2)) - (B(2) - A(2))*(C(1) - A(1))
      VOL = X*(D(1) - A(1)) + Y*(D(2) - A(2)) + Z*(D(3) - A(3))
      END

! Progress and cancelling.
      SUBROUTINE TSTPRO
      IMPLICIT NONE
      INTEGER N
      PARAMETER (N = 2000)
      INTEGER H(4), IERR, NCALL, NVT, HBUSY(4), NBUSY, I
      DOUBLE PRECISION XYZ(3, N), STOPAT
      EXTERNAL HEAR, BARGE
      COMMON /HEARD/ STOPAT, NCALL
      COMMON /BUSY/ HBUSY, NBUSY
      SAVE XYZ
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(N, XYZ)
      CALL MGNEW(H, IERR)
      NCALL = 0
      STOPAT = 2
      CALL MGPROG(H, HEAR, IERR)
      CALL GOOD(H, IERR, 'MGPROG')
      CALL MGINS(H, N, XYZ, IERR)
      CALL GOOD(H, IERR, 'MGINS with progress')
      CALL EXPECT(NCALL .GE. 10, 'progress is heard')
      CALL MGCLR(H, IERR)
      STOPAT = 0.5D0
      CALL MGINS(H, N, XYZ, IERR)
      CALL BAD(H, IERR, MGECAN, 'cancel')
      CALL MGNVT(H, NVT, IERR)
      CALL EXPECT(NVT .GT. 0 .AND. NVT .LT. N - 1, 'some are in')
      CALL MGCHK(H, MGCCAN, IERR)
      CALL GOOD(H, IERR, 'valid after cancelling')
      CALL MGNOPR(H, IERR)
      CALL GOOD(H, IERR, 'MGNOPR')
      NCALL = 0
      CALL MGCANC(H, IERR)
      CALL GOOD(H, IERR, 'MGCANC')
      CALL MGINS(H, N, XYZ, IERR)
      CALL EXPECT(IERR .EQ. MGECAN .AND. NCALL .EQ. 0, 'cancelled')
! What calls the handle that hears is refused, and harms nothing.
      DO 10 I = 1, 4
        HBUSY(I) = H(I)
   10 CONTINUE
      NBUSY = 0
      CALL MGCLR(H, IERR)
      CALL MGPROG(H, BARGE, IERR)
      CALL MGINS(H, N, XYZ, IERR)
      CALL GOOD(H, IERR, 'MGINS with calls in it')
      CALL EXPECT(NBUSY .GT. 10, 'a call in a call is refused')
      CALL MGCHK(H, MGCCAN, IERR)
      CALL GOOD(H, IERR, 'valid after calls in calls')
      CALL MGFREE(H, IERR)
      CALL GOOD(H, IERR, 'MGFREE after calls in calls')
      END

      SUBROUTINE BARGE(FRAC, ICANC)
      IMPLICIT NONE
      DOUBLE PRECISION FRAC, P(3)
      INTEGER ICANC, HBUSY(4), NBUSY, IERR1, IERR2, IERR3
      COMMON /BUSY/ HBUSY, NBUSY
      INCLUDE 'mgdt_f77.inc'
      DATA P /0.5D0, 0.5D0, 0.5D0/
      CALL MGINS(HBUSY, 1, P, IERR1)
      CALL MGTHR(HBUSY, 2, IERR2)
      CALL MGFREE(HBUSY, IERR3)
      IF (IERR1 .EQ. MGEBSY .AND. IERR2 .EQ. MGEBSY .AND.
     &    IERR3 .EQ. MGEBSY) NBUSY = NBUSY + 1
      IF (FRAC .LT. 0 .OR. ICANC .NE. 0) NBUSY = -1000
      END

      SUBROUTINE HEAR(FRAC, ICANC)
      IMPLICIT NONE
      DOUBLE PRECISION FRAC, STOPAT
      INTEGER ICANC, NCALL
      COMMON /HEARD/ STOPAT, NCALL
      IF (ICANC .EQ. 0) NCALL = NCALL + 1
      IF (FRAC .GE. STOPAT) ICANC = 1
      END

! Bad handles and bad values.
      SUBROUTINE TSTBAD
      IMPLICIT NONE
      INTEGER H(4), IERR, N, I, K
      DOUBLE PRECISION XYZ(3, 20), V
      CHARACTER*40 TEXT
      INCLUDE 'mgdt_f77.inc'
      CALL MKPTS(20, XYZ)
! A handle of zeros, of garbage, of large garbage.
      DO 20 K = 1, 3
        DO 10 I = 1, 4
          H(I) = 0
          IF (K .EQ. 2) H(I) = 12345 + I
          IF (K .EQ. 3) H(I) = HUGE(H) - I
   10   CONTINUE
        N = 77
        CALL MGINS(H, 20, XYZ, IERR)
        CALL EXPECT(IERR .EQ. MGENUL, 'MGINS on a bad handle')
        CALL MGNTET(H, N, IERR)
        CALL EXPECT(IERR .EQ. MGENUL .AND. N .EQ. 77, 'count of it')
        CALL MGDIM(H, N, IERR)
        CALL EXPECT(IERR .EQ. MGENUL .AND. N .EQ. 77, 'MGDIM of it')
        TEXT = 'an old message'
        CALL MGERR(H, TEXT, IERR)
        CALL EXPECT(IERR .EQ. MGENUL .AND. TEXT .EQ. ' ',
     +              'message of it')
        CALL MGISAN(H, TEXT, IERR)
        CALL EXPECT(IERR .EQ. MGENUL, 'instruction set of it')
        CALL MGNEAR(H, XYZ, N, IERR)
        CALL EXPECT(IERR .EQ. MGENUL .AND. N .EQ. 77, 'MGNEAR of it')
        CALL MGLOC(H, XYZ, N, IERR)
        CALL EXPECT(IERR .EQ. MGENUL .AND. N .EQ. 77, 'MGLOC of it')
        CALL MGFREE(H, IERR)
        CALL EXPECT(IERR .EQ. MGENUL, 'MGFREE of it')
   20 CONTINUE
      CALL MGNEW(H, IERR)
      CALL MGINS(H, 20, XYZ, IERR)
      CALL GOOD(H, IERR, 'MGINS')
      CALL MGINS(H, -1, XYZ, IERR)
      CALL BAD(H, IERR, MGEARG, '-1')
      CALL MGORDN(H, 5, IERR)
      CALL BAD(H, IERR, MGESCH, 'order scheme 5')
      CALL MGORD(H, 'nonsense', IERR)
      CALL BAD(H, IERR, MGESCH, 'order scheme -1')
      CALL MGORD(H, 'MULTI-GRID', IERR)
      CALL GOOD(H, IERR, 'MGORD')
      CALL MGGORD(H, K, IERR)
      CALL EXPECT(IERR .EQ. 0 .AND. K .EQ. MGOMUL, 'capitals')
      CALL MGPAR(H, 11, 1D0, IERR)
      CALL BAD(H, IERR, MGEKEY, '11')
      CALL MGTHR(H, -1, IERR)
      CALL BAD(H, IERR, MGEARG, '-1')
      CALL MGBASE(H, 2, IERR)
      CALL BAD(H, IERR, MGEARG, 'is 2')
      CALL MGMEM(H, -1D0, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'a negative limit')
      CALL MGMEM(H, 1D300, IERR)
      CALL EXPECT(IERR .EQ. MGEARG, 'a limit beyond all')
      CALL MGCOMP(H, 2, IERR)
      CALL BAD(H, IERR, MGEARG, 'is 2')
      CALL MGCANO(H, 2, IERR)
      CALL BAD(H, IERR, MGEARG, 'is 2')
      CALL MGISA(H, 'abacus', IERR)
      CALL BAD(H, IERR, MGEARG, 'abacus')
      CALL MGCHK(H, 4, IERR)
      CALL BAD(H, IERR, MGEARG, 'check level 4')
      V = 77
      CALL MGSTAT(H, 9, V, IERR)
      CALL BAD(H, IERR, MGEKEY, '9')
      CALL EXPECT(V .EQ. 77, 'the figure is not touched')
      CALL MGRSV(H, -1, IERR)
      CALL BAD(H, IERR, MGEARG, '-1')
      CALL MGCHK(H, MGCCAN, IERR)
      CALL GOOD(H, IERR, 'valid after all that')
      CALL MGFREE(H, IERR)
      CALL GOOD(H, IERR, 'MGFREE')
      CALL MGFREE(H, IERR)
      CALL EXPECT(IERR .EQ. MGENUL, 'freed twice')
      END
