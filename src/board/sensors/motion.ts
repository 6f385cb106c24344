import type { Clock } from '#core/clock';
import { GestureRecogniser, SAMPLES_TO_REST, type Acceleration, type Gesture } from './gestures';
import type { Sensors } from './sensors';

const SAMPLE_US = 20_000; // codal-core Accelerometer.cpp: samplePeriod
const HISTORY = 16; // microbit_accelerometer.c: GESTURE_LIST_SIZE 8, two gestures a byte
const RANGES_G = [2, 4, 8] as const; // what set_range is documented to round to
/** The largest range that a program can set for the accelerometer, in g. */
export const WIDEST_G = RANGES_G[2];
/** The sensors that make an acceleration: they change with most steps of the world. */
const AXES = new Map([
  ['accelerometerX', 'x'],
  ['accelerometerY', 'y'],
  ['accelerometerZ', 'z'],
] as const);

/** The axis that a sensor measures, if it is one of the accelerometer's. */
const axisOf = (id: string): 'x' | 'y' | 'z' | undefined => (AXES as ReadonlyMap<string, 'x' | 'y' | 'z'>).get(id);

/** Sets the range of the accelerometer's sensors to ± this value. */
export function limitReach(sensors: Sensors, mg: number): void {
  for (const id of AXES.keys()) sensors.limit(id, -mg, mg);
}

/**
 * The accelerometer. It samples every 20 ms, at whole multiples since the start of the run; gestures are found in these
 * samples, and each setting of the sensor `gesture` makes another one.
 *
 * It sets no alarm: missed samples are caught up when a program asks, with the same result. At the start the board has
 * been at rest for a while: it senses gravity, and its posture is its first gesture.
 */
export class Motion {
  private readonly raw = { x: 0, y: 0, z: 0 };
  private latest: Acceleration = this.raw;
  private samples = 0;
  private reachMg = 2000;
  private recogniser = this.createRecogniser();
  private lastGesture: Gesture = '';
  private readonly were = new Set<Gesture>();
  private history: Gesture[] = [];

  constructor(
    private readonly clock: Clock,
    private readonly sensors: Sensors,
  ) {
    this.lie();
    sensors.onSet((id) => this.hear(id));
  }

  /** The latest sample, whole mg. */
  get acceleration(): Acceleration {
    this.catchUp();
    return this.latest;
  }

  /** The strength of the acceleration, whole mg. */
  get strength(): number {
    const { x, y, z } = this.acceleration;
    return Math.floor(Math.sqrt(x * x + y * y + z * z));
  }

  /** Range of each axis in both directions, mg. */
  get rangeMg(): number {
    return this.reachMg;
  }

  /** Rounds up to 2, 4 or 8 g (larger values: 8). The three sensors then have the same range. */
  setRange(g: number): void {
    this.catchUp();
    this.reachMg = (RANGES_G.find((range) => range >= g) ?? WIDEST_G) * 1000;
    limitReach(this.sensors, this.reachMg);
    this.readSensors();
  }

  /** The present gesture; empty for none. A posture remains until another gesture follows. */
  get gesture(): Gesture {
    this.catchUp();
    return this.lastGesture;
  }

  /** True if the gesture was made since the last call; also clears the list of `takeGestures`. */
  wasGesture(gesture: Gesture): boolean {
    this.catchUp();
    this.history = [];
    return this.were.delete(gesture);
  }

  /** The gestures since the last call, oldest first, at most 16. */
  takeGestures(): readonly Gesture[] {
    this.catchUp();
    const taken = this.history;
    this.history = [];
    return taken;
  }

  /** Back to the state after a start: 2 g, no gesture but the posture. The sensor values stay. */
  reset(): void {
    this.setRange(2);
    this.lie();
  }

  /** Treats the board as having been at rest, as its sensors are set, for as long as a gesture needs. */
  private lie(): void {
    this.recogniser = this.createRecogniser();
    this.lastGesture = '';
    this.were.clear();
    this.history = [];
    this.readSensors();
    this.latest = { ...this.raw };
    this.feel(SAMPLES_TO_REST);
  }

  private createRecogniser(): GestureRecogniser {
    return new GestureRecogniser((gesture) => this.note(gesture));
  }

  private note(gesture: Gesture): void {
    this.lastGesture = gesture;
    if (gesture === '') return;
    this.were.add(gesture);
    if (this.history.length < HISTORY) this.history.push(gesture);
  }

  private hear(id: string): void {
    const axis = axisOf(id);
    if (axis !== undefined) {
      // A value set before anything has run is the board's posture at the start.
      if (this.clock.nowUs === 0) return this.lie();
      this.catchUp();
      this.raw[axis] = Math.trunc(this.sensors.get(id));
    } else if (id === 'gesture') {
      this.catchUp();
      const gesture = this.sensors.get('gesture');
      if (gesture === 'none') this.lastGesture = this.recogniser.current;
      else this.note(gesture as Gesture);
    }
  }

  private readSensors(): void {
    for (const [id, axis] of AXES) this.raw[axis] = Math.trunc(this.sensors.get(id));
  }

  /** Catches up on the samples since the last call: they were all equal. */
  private catchUp(): void {
    const due = Math.floor(this.clock.nowUs / SAMPLE_US);
    const missing = Math.min(due - this.samples, SAMPLES_TO_REST);
    if (missing <= 0) return;
    this.samples = due;
    this.latest = { ...this.raw };
    this.feel(missing);
  }

  private feel(samples: number): void {
    for (let i = 0; i < samples; i++) this.recogniser.sample(this.latest);
  }
}
