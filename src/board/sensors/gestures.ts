/** Gestures in the order of codal-core Accelerometer.h; the first is no gesture. The names are those of Python. */
export const GESTURE_NAMES = [
  '',
  'up',
  'down',
  'left',
  'right',
  'face up',
  'face down',
  'freefall',
  '3g',
  '6g',
  '8g',
  'shake',
  '2g',
] as const;

/** A gesture, as Python names it; empty for no gesture. */
export type Gesture = (typeof GESTURE_NAMES)[number];

// All from codal-core Accelerometer.h, in mg and samples.
const TILT_MG = 800; // 1000 less the tolerance of 200
const FREEFALL_MG = 400;
const SHAKE_MG = 400;
const IMPULSES: readonly (readonly [gesture: Gesture, mg: number])[] = [
  ['2g', 2048],
  ['3g', 3072],
  ['6g', 6144],
  ['8g', 8192],
];
const DAMPING = 5; // samples that a posture has to last, after the first
const SHAKE_CROSSINGS = 4;
const SHAKE_DAMPING = 10; // samples after which a swing is forgotten
const SHAKE_PAUSE = 30; // samples after a shake before the next can begin

/** After this many equal samples nothing changes any more: 30 to forget swings, or for the pause; 5 of damping. */
export const SAMPLES_TO_REST = 64;

/** Acceleration along the three axes in mg. */
export interface Acceleration {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/**
 * Finds gestures in a series of samples, 20 ms apart: postures that last six samples, blows above 2, 3, 6 and 8 g, and
 * shakes (four swings beyond ±400 mg in quick succession). Source: codal-core Accelerometer.cpp, updateGesture and
 * instantaneousPosture.
 */
export class GestureRecogniser {
  private posture: Gesture = '';
  private stable = 0;
  private last: Gesture = '';
  /** Blows that were reported and have not subsided. At a start these are all, so that switching on is not a blow. */
  private readonly told = new Set<Gesture>(IMPULSES.map(([gesture]) => gesture));
  private sinceImpulse = 0;
  private readonly swing = { x: false, y: false, z: false };
  private swings = 0;
  private swingTimer = 0;
  private shaken = false;

  /** @param tell called with every gesture when it is made */
  constructor(private readonly tell: (gesture: Gesture) => void) {}

  /** The last gesture that was recognised; a posture remains until another gesture follows. */
  get current(): Gesture {
    return this.last;
  }

  sample(a: Acceleration): void {
    const square = a.x * a.x + a.y * a.y + a.z * a.z;
    this.feelBlows(square);
    if (this.isShake(a)) {
      this.last = 'shake';
      this.tell('shake');
      return;
    }
    const posture = square < FREEFALL_MG * FREEFALL_MG ? 'freefall' : postureOf(a);
    if (posture === this.posture) {
      if (this.stable < DAMPING) this.stable++;
    } else {
      this.posture = posture;
      this.stable = 0;
    }
    if (this.posture !== this.last && this.stable >= DAMPING) {
      this.last = this.posture;
      this.tell(this.last);
    }
  }

  private feelBlows(square: number): void {
    if (square > 2048 * 2048) {
      for (const [gesture, mg] of IMPULSES) {
        if (square > mg * mg && !this.told.has(gesture)) {
          this.told.add(gesture);
          this.tell(gesture);
        }
      }
      this.sinceImpulse = 0;
    }
    if (this.sinceImpulse < DAMPING) this.sinceImpulse++;
    else this.told.clear();
  }

  private isShake(a: Acceleration): boolean {
    const swung = this.swings < SHAKE_CROSSINGS;
    if (this.hasSwung(a) && swung) {
      this.swings++;
      if (this.swings === 1) this.swingTimer = 0;
      if (this.swings === SHAKE_CROSSINGS) {
        this.shaken = true;
        this.swingTimer = 0;
        return true;
      }
    }
    if (this.swings > 0) {
      this.swingTimer++;
      if (this.shaken && this.swingTimer >= SHAKE_PAUSE) {
        this.shaken = false;
        this.swingTimer = 0;
        this.swings = 0;
      } else if (!this.shaken && this.swingTimer >= SHAKE_DAMPING) {
        this.swingTimer = 0;
        this.swings--;
      }
    }
    return false;
  }

  private hasSwung(a: Acceleration): boolean {
    let swung = false;
    for (const axis of ['x', 'y', 'z'] as const) {
      const isBeyond = this.swing[axis] ? a[axis] < -SHAKE_MG : a[axis] > SHAKE_MG;
      if (isBeyond) {
        this.swing[axis] = !this.swing[axis];
        swung = true;
      }
    }
    return swung;
  }
}

function postureOf({ x, y, z }: Acceleration): Gesture {
  if (x < -TILT_MG) return 'left';
  if (x > TILT_MG) return 'right';
  if (y < -TILT_MG) return 'down';
  if (y > TILT_MG) return 'up';
  if (z < -TILT_MG) return 'face up';
  return z > TILT_MG ? 'face down' : '';
}
