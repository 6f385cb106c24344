/** How a motor output is shown. */
export interface MotorLook {
  readonly direction: 'forwards' | 'backwards' | 'still';
  /** Turns of the drawn wheel in a second, positive forwards, i.e. clockwise. */
  readonly turnsPerSecond: number;
  /** Signed whole per cent, e.g. "60 %" or "−25 %". */
  readonly percent: string;
}

/** Full duty turns the drawn wheel this often. Chosen: fast, while its spokes can still be followed by the eye. */
const FULL_TURNS_PER_SECOND = 1.5;

/** How a motor of this duty looks; −1 … 1, positive forwards, anything beyond counts as full. */
export function motorLook(duty: number): MotorLook {
  const within = Math.max(-1, Math.min(1, duty));
  const percent = Math.round(within * 100);
  return {
    direction: within > 0 ? 'forwards' : within < 0 ? 'backwards' : 'still',
    turnsPerSecond: within * FULL_TURNS_PER_SECOND,
    percent: `${percent < 0 ? '−' : ''}${String(Math.abs(percent))} %`,
  };
}
