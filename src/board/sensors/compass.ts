import type { Sensors } from './sensors';

/** The magnetic field along the three axes in nT. */
export interface Field {
  readonly x: number;
  readonly y: number;
  readonly z: number;
}

/**
 * The compass. Heading and field are set from outside and independent of each other, as in the official simulator.
 *
 * It counts as calibrated from the start (on the device the last calibration is stored in the flash memory).
 * Calibrating takes no time and requires no tilting: a board in a simulator has no iron near it (chosen).
 */
export class Compass {
  private calibrated = true;

  constructor(private readonly sensors: Sensors) {}

  /** Direction of the logo: whole degrees from north, clockwise, 0 … 359. Calibrates if that has not been done. */
  heading(): number {
    this.calibrated = true;
    return Math.trunc(this.sensors.get('compassHeading')) % 360;
  }

  /** Whole nT. */
  get field(): Field {
    const read = (id: string): number => Math.trunc(this.sensors.get(id));
    return { x: read('compassX'), y: read('compassY'), z: read('compassZ') };
  }

  /** The strength of the whole field, whole nT. */
  get fieldStrength(): number {
    const { x, y, z } = this.field;
    return Math.floor(Math.sqrt(x * x + y * y + z * z));
  }

  get isCalibrated(): boolean {
    return this.calibrated;
  }

  calibrate(): void {
    this.calibrated = true;
  }

  clearCalibration(): void {
    this.calibrated = false;
  }

  /** Back to the state after a start. */
  reset(): void {
    this.calibrated = true;
  }
}
