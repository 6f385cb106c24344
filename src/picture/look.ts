import type { CourseColors } from './colors';

/** The view of a picture: the detail that can be distinguished, and the colours. */
export interface Look {
  readonly colors: CourseColors;
  /** Size of a pixel, in mm: smaller things are left out, thin lines are that wide. On paper a quarter more than a mm. */
  readonly px: number;
  /** Lines and walls are no thinner, in mm; left out: they are as wide as they are. */
  readonly leastLineMm?: number;
  /** No sign of a zone and no name of a start is set in smaller type, in mm; left out: all as it is. */
  readonly leastTypeMm?: number | undefined;
  /** How long a mover waits, in the language that is shown. */
  readonly seconds: (seconds: number) => string;
}

/** A pixel of what is printed or saved, in mm: large enough that all is shown of a course of the usual size. */
export const PRINT_PX = 1.25;
