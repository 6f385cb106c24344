import type { CourseColors } from './colors';

/** The view of a picture: the detail that can be distinguished, and the colours. */
export interface Look {
  readonly colors: CourseColors;
  /** Size of a pixel, in mm: details too small for it are left out, and edges are no thinner than about 1.5 of it. */
  readonly px: number;
  /** Least width of lines and walls, in mm; left out: none. */
  readonly leastLineMm?: number;
  /** Least size of signs of zones, names of starts and waiting times, in mm; left out: none. */
  readonly leastTypeMm?: number | undefined;
  /** True where the light of lamps and shadows is drawn; left out: on paper and in small pictures it is not. */
  readonly isLit?: boolean;
  /** Writes a number of seconds for which a mover waits, in the language that is shown. */
  readonly seconds: (seconds: number) => string;
}

/** A pixel of what is printed or saved, in mm: large enough that all is shown of a course of the usual size. */
export const PRINT_PX = 1.25;
