/**
 * The speed control that register 0x0A switches on. The controller measures the speed of the wheels and changes the
 * motors' power until it reaches the requested speed. The robot then keeps its speed, even a slow one at which a motor
 * alone would stick.
 *
 * Its rule is not published. Chosen: a proportional and an integral part, as the maker's name for it ("PID") says, and
 * a speed that grows evenly with the byte. Source of the speed: Tiger-Jython/Robotics-Libraries `mbrobot_plus.py` sends
 * byte 59 with control for speed 29 and byte 32 without for speed 30, so the two drive about equally fast.
 */

/** Wheel speed per power byte under control, in mm/s: 153 mm/s (the speed of byte 32 without control) at byte 59. */
export const MM_PER_S_PER_BYTE = 2.6;

/** Power per mm/s of missing speed, and its increase per second. Chosen: steady in 0.3 s, without oscillation. */
const PROPORTIONAL = 0.001;
const INTEGRAL_PER_S = 0.02;

const FULL_BYTE = 255;

/** The control of one wheel. */
export interface SpeedControl {
  /**
   * @param wanted duty as the program set it, −1 … 1
   * @param speedMmPerS speed of the wheel, of a robot of real size
   * @param passedS since the last call
   * @returns the duty that drives the motor
   */
  next(wanted: number, speedMmPerS: number, passedS: number): number;
  /** Forgets its sum. */
  reset(): void;
}

/** Makes the control of one wheel. */
export function createSpeedControl(): SpeedControl {
  let sum = 0;
  return {
    next: (wanted, speedMmPerS, passedS) => {
      if (wanted === 0) {
        sum = 0;
        return 0;
      }
      const missing = wanted * FULL_BYTE * MM_PER_S_PER_BYTE - speedMmPerS;
      sum = clamp(sum + INTEGRAL_PER_S * missing * passedS);
      return clamp(sum + PROPORTIONAL * missing);
    },
    reset: () => {
      sum = 0;
    },
  };
}

const clamp = (duty: number): number => Math.min(Math.max(duty, -1), 1);
