! SPDX-License-Identifier: MIT
! Asks whether the kinds of numbers agree, and triangulates if they do.
      PROGRAM ASKED
      IMPLICIT NONE
      INTEGER H(4), IERR, NT, ITET(4, 10), IOWN(2)
      DOUBLE PRECISION XYZ(3, 5)
      INCLUDE 'mgdt_f77.inc'
      DATA XYZ /0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1/
      DATA IOWN /1, 2/
      IERR = -1
      CALL MGKIND(MGKI, MGKD, IERR)
      IF (IERR .EQ. MGEARG) THEN
! The same without names.
        IERR = -1
        CALL MGKIND(IOWN, 1D0, IERR)
        IF (IERR .EQ. MGEARG) WRITE (*, '(A)') 'kinds differ'
        STOP
      END IF
      IF (IERR .NE. MGOK) STOP 1
      IERR = -1
      CALL MGKIND(IOWN, 1D0, IERR)
      IF (IERR .NE. MGOK) STOP 2
      CALL MGNEW(H, IERR)
      IF (IERR .EQ. MGOK) CALL MGINS(H, 5, XYZ, IERR)
      IF (IERR .EQ. MGOK) CALL MGNTET(H, NT, IERR)
      IF (IERR .EQ. MGOK) CALL MGTETS(H, 10, ITET, IERR)
      IF (IERR .EQ. MGOK) CALL MGCHK(H, MGCCAN, IERR)
      IF (IERR .NE. MGOK .OR. NT .NE. 2) STOP 3
      IF (ITET(1, 1) + ITET(2, 1) + ITET(3, 1) + ITET(4, 1) +
     &    ITET(1, 2) + ITET(2, 2) + ITET(3, 2) + ITET(4, 2)
     &    .NE. 2*(2 + 3 + 4) + 1 + 5) STOP 4
      CALL MGFREE(H, IERR)
      WRITE (*, '(A)') 'kinds agree'
      END
