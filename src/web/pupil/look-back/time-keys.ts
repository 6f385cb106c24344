/** One moment of the tape, in µs. */
export const STEP_US = 20_000;
const FAR_US = 1_000_000;

/** The moment to which a key of the time line leads; `null`: it is none of its keys. */
export function keyStep(key: string, atUs: number, endUs: number): number | null {
  switch (key) {
    case 'ArrowLeft':
    case 'ArrowDown':
      return atUs - STEP_US;
    case 'ArrowRight':
    case 'ArrowUp':
      return atUs + STEP_US;
    case 'PageDown':
      return atUs - FAR_US;
    case 'PageUp':
      return atUs + FAR_US;
    case 'Home':
      return 0;
    case 'End':
      return endUs;
    default:
      return null;
  }
}
