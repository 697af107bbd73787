! SPDX-License-Identifier: MIT
! Does not ask. COMMON blocks say where the variables are. Those of the
! first two show that integers are shorter than they should be; those of
! the third do so when a count is asked for.
      PROGRAM SHOWN
      IMPLICIT NONE
      INTEGER H(4), IERR, LAST
      COMMON /NEXT/ H, IERR, LAST
      LAST = -7
      IERR = -1
      CALL MGNEW(H, IERR)
      CALL TELL('next', IERR)
      IF (LAST .NE. -7) WRITE (*, '(A)') 'overwritten'
      IF (IERR .EQ. 0) CALL MGFREE(H, IERR)
      CALL ODD
      CALL APART
      END

      SUBROUTINE ODD
      IMPLICIT NONE
      INTEGER H(4), IGAP(5), IERR, LAST
      COMMON /PLACES/ H, IGAP, IERR, LAST
      LAST = -7
      IERR = -1
      CALL MGNEW(H, IERR)
      CALL TELL('odd', IERR)
      IF (LAST .NE. -7) WRITE (*, '(A)') 'overwritten'
      IF (IERR .EQ. 0) CALL MGFREE(H, IERR)
      END

      SUBROUTINE APART
      IMPLICIT NONE
      INTEGER H(4), IGAP(4), IERR, N, LAST, I
      COMMON /FAR/ H, IGAP, IERR, N, LAST
      DO 10 I = 1, 4
        IGAP(I) = -7
   10 CONTINUE
      IERR = -1
      CALL MGNEW(H, IERR)
      DO 20 I = 1, 4
        IF (IGAP(I) .NE. -7) WRITE (*, '(A)') 'behind H'
   20 CONTINUE
      N = -7
      LAST = -7
      IF (IERR .EQ. 0) CALL MGNTET(H, N, IERR)
      CALL TELL('apart', IERR)
      IF (IERR .EQ. 0 .AND. N .NE. 0) WRITE (*, '(A)') 'no count'
      IF (IERR .NE. 0 .AND. N .NE. -7) WRITE (*, '(A)') 'overwritten'
      IF (LAST .NE. -7) WRITE (*, '(A)') 'overwritten'
      IF (IERR .EQ. 0) CALL MGFREE(H, IERR)
      END

      SUBROUTINE TELL(WHAT, IERR)
      IMPLICIT NONE
      CHARACTER*(*) WHAT
      INTEGER IERR
      IF (IERR .EQ. 0) THEN
        WRITE (*, '(2A)') WHAT, ': no difference'
      ELSE IF (IERR .EQ. 11) THEN
        WRITE (*, '(2A)') WHAT, ': kinds differ'
      ELSE
        WRITE (*, '(2A, I22)') WHAT, ': status', IERR
      END IF
      END
