import { Trail } from './trail';

/** The paths of a run's robots, by the place of their device. */
export class Trails {
  private readonly all = new Map<number, Trail>();

  /** The first device's. */
  get first(): Trail {
    return this.of(0);
  }

  /** A device's; always the same object. */
  of(device: number): Trail {
    const known = this.all.get(device);
    if (known !== undefined) return known;
    const trail = new Trail();
    this.all.set(device, trail);
    return trail;
  }

  /** Adds points in the form of a snapshot, for each device: x and y alternately. */
  add(xyMm: readonly (readonly number[])[], timeUs: number): void {
    xyMm.forEach((points, device) => this.of(device).add(points, timeUs));
  }

  /** Shows them as far as they went at a moment; `null`: all of them. */
  lookAt(timeUs: number | null): void {
    for (const trail of this.all.values()) trail.lookAt(timeUs);
  }

  clear(): void {
    for (const trail of this.all.values()) trail.clear();
  }
}
