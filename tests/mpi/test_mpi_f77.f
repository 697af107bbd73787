C SPDX-License-Identifier: MIT
C     The FORTRAN 77 subroutines of MPI, each of them.
      PROGRAM TMPI77
      IMPLICIT NONE
      INCLUDE 'mpif.h'
      INCLUDE 'mgdt_f77.inc'
      INCLUDE 'mgdt_mpi_f77.inc'
      INTEGER N, MAXV
      PARAMETER (N = 300, MAXV = 20000)
      INTEGER H(4), HT(4), IERR, IER2, RANK, RANKS, I, K, M, NBAD
      INTEGER NT, NV, IV(MAXV), IDS(N), ISTATE, NALL
      DOUBLE PRECISION XYZ(3,N), ALL(3,N), AT(3,N)
      CHARACTER*80 TEXT
      COMMON /HEARD/ M
      EXTERNAL HEAR
C     All integers of MPI are of the C compiler's kind.
      INTEGER*4 IE, IR, IS
      CALL MPI_INIT(IE)
      CALL MPI_COMM_RANK(MPI_COMM_WORLD, IR, IE)
      CALL MPI_COMM_SIZE(MPI_COMM_WORLD, IS, IE)
      RANK = IR
      RANKS = IS
      NBAD = 0
      ISTATE = 7
      M = 0
      DO 20 I = 1, N
        DO 10 K = 1, 3
          ISTATE = MOD(ISTATE*3877 + 29573, 139968)
          ALL(K,I) = ISTATE/139968D0
   10   CONTINUE
        IF (MOD(I, RANKS) .EQ. RANK) THEN
          M = M + 1
          IDS(M) = I
          XYZ(1,M) = ALL(1,I)
          XYZ(2,M) = ALL(2,I)
          XYZ(3,M) = ALL(3,I)
        END IF
   20 CONTINUE
      K = M
      CALL MGNEW(HT, IERR)
      CALL MGINS(HT, N, ALL, IERR)
      CALL MGNTET(HT, NALL, IERR)

      CALL MGMNEW(INT(MPI_COMM_WORLD), H, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMNEW', NBAD)
C     Neither takes the other's handle.
      CALL MGMBLD(HT, IERR)
      CALL EXPECT(IERR, MGENUL, 'a handle of MGNEW', NBAD)
      CALL MGNTET(H, NT, IERR)
      CALL EXPECT(IERR, MGENUL, 'a handle of MGMNEW', NBAD)
      CALL MGMIDS(H, K, XYZ, IDS, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMIDS', NBAD)
      M = 0
      CALL MGMPRG(H, HEAR, IERR)
      CALL MGMBLD(H, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMBLD', NBAD)
      IF (M .LT. 5) CALL EXPECT(0, 1, 'progress', NBAD)
      CALL MGMNOP(H, IERR)
      CALL MGMNUM(H, MGQATE, NT, IERR)
      CALL EXPECT(NT, NALL, 'tetrahedra of all', NBAD)
      CALL MGMNUM(H, MGQNVT, NV, IERR)
      CALL MGMXYZ(H, N, AT, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMXYZ', NBAD)
      CALL MGMARR(H, MGQVID, MAXV, IV, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMARR', NBAD)
      DO 30 I = 1, NV
        IF (AT(2,I) .NE. ALL(2,IV(I)))
     &    CALL EXPECT(0, 1, 'the id of a vertex', NBAD)
   30 CONTINUE
      CALL MGMSIZ(H, MGQCOR, NT, IERR)
      CALL MGMARR(H, MGQCOR, NT - 1, IV, IERR)
      CALL EXPECT(IERR, MGEBUF, 'too small', NBAD)
      CALL MGMARR(H, MGQCOR, MAXV, IV, IERR)
      DO 40 I = 1, NT
        IF (IV(I) .LT. 1 .OR. IV(I) .GT. N)
     &    CALL EXPECT(0, 1, 'a corner', NBAD)
   40 CONTINUE
      CALL MGMCHK(H, MGCCAN, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMCHK', NBAD)
      CALL MGMARR(H, 77, MAXV, IV, IERR)
      CALL EXPECT(IERR, MGEKEY, 'no array', NBAD)
      CALL MGMERR(H, TEXT, IERR)
      IF (TEXT .NE. 'there is no array 77')
     &  CALL EXPECT(0, 1, TEXT, NBAD)
      CALL MGMCAN(H, IERR)
      CALL MGMBLD(H, IERR)
      CALL EXPECT(IERR, MGECAN, 'MGMCAN', NBAD)
      CALL MGMCLR(H, IERR)
      CALL MGMINS(H, K, XYZ, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMINS', NBAD)
      CALL MGMOPT(H, MGQTHR, 2, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMOPT', NBAD)
      CALL MGMBLD(H, IERR)
      CALL MGMNUM(H, MGQATE, NT, IERR)
      CALL EXPECT(NT, NALL, 'tetrahedra without ids', NBAD)
      CALL MGMFRE(H, IERR)
      CALL EXPECT(IERR, MGOK, 'MGMFRE', NBAD)
      CALL MGMBLD(H, IER2)
      CALL EXPECT(IER2, MGENUL, 'after MGMFRE', NBAD)
      CALL MGFREE(HT, IERR)
      CALL MPI_FINALIZE(IE)
      IF (NBAD .NE. 0) STOP 1
      END

      SUBROUTINE EXPECT(I, J, WHAT, NBAD)
      INTEGER I, J, NBAD
      CHARACTER*(*) WHAT
      IF (I .EQ. J) RETURN
      NBAD = NBAD + 1
      PRINT *, 'failed: ', WHAT, I, J
      END

      SUBROUTINE HEAR(FRAC, ICANC)
      DOUBLE PRECISION FRAC
      INTEGER ICANC, M
      COMMON /HEARD/ M
      IF (FRAC .GE. 0D0 .AND. ICANC .EQ. 0) M = M + 1
      END
