! SPDX-License-Identifier: MIT
! Numbers beyond 32 bits (overflow.c): refused if INTEGER is too short,
! told if it is long enough. LONG tells which.
      PROGRAM TSTOVR
      IMPLICIT NONE
      INTEGER H(4), IERR, I, N(8), NBAD, ITET(4), NT
      DOUBLE PRECISION P(3)
      LOGICAL LONG, RIGHT
      INCLUDE 'mgdt_f77.inc'
      DATA P /3*0D0/
      LONG = BIT_SIZE(I) .GT. 32
      CALL MGNEW(H, IERR)
      IF (IERR .NE. 0) STOP 2
      NBAD = 0
      DO 20 I = 1, 8
        N(I) = -5
        IF (I .EQ. 1) CALL MGNPT(H, N(I), IERR)
        IF (I .EQ. 2) CALL MGNVT(H, N(I), IERR)
        IF (I .EQ. 3) CALL MGNTET(H, N(I), IERR)
        IF (I .EQ. 4) CALL MGNHUL(H, N(I), IERR)
        IF (I .EQ. 5) CALL MGNEDG(H, N(I), IERR)
        IF (I .EQ. 6) CALL MGNVTT(H, N(I), IERR)
        IF (I .EQ. 7) CALL MGNEAR(H, P, N(I), IERR)
        IF (I .EQ. 8) CALL MGGSED(H, N(I), IERR)
        IF (LONG) THEN
          RIGHT = IERR .EQ. MGOK .AND. N(I)/1000000 .GE. 3000
        ELSE
          RIGHT = IERR .EQ. MGERNG .AND. N(I) .EQ. -5
        END IF
        IF (.NOT. RIGHT) NBAD = NBAD + 1
        IF (.NOT. RIGHT) WRITE (*, *) 'number', I, IERR, N(I)
   20 CONTINUE
! Columns are counted so that 4*MAXT may pass what an INTEGER holds.
      NT = 1000000000
      CALL MGTETS(H, NT, ITET, IERR)
      IF (IERR .NE. MGEBUF) NBAD = NBAD + 1
      NT = HUGE(NT)
      CALL MGTETS(H, NT, ITET, IERR)
      RIGHT = IERR .EQ. MGEBUF
      IF (LONG) RIGHT = IERR .EQ. MGOK
      IF (.NOT. RIGHT) NBAD = NBAD + 1
      IF (.NOT. RIGHT) WRITE (*, *) 'capacity', IERR
! A copy that there is no memory for.
      CALL LIMIT_MEMORY
      CALL MGTETI(H, 1000000000, ITET, 5, 1, IERR)
      IF (IERR .NE. MGEMEM) NBAD = NBAD + 1
      IF (IERR .NE. MGEMEM) WRITE (*, *) 'copy', IERR
      CALL MGFREE(H, IERR)
      WRITE (*, '(I3, A)') NBAD, ' of 11 failed'
      IF (NBAD .GT. 0) STOP 1
      END
