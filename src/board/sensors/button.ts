import { Debounce } from './debounce';
import type { TickGrid } from '../tick-grid';
import type { Wire, WireEnd } from '../wires/wire';

/**
 * A push button between a wire and ground, with the pull-up of the board. Whoever else pulls the wire low presses it
 * too, as on the device.
 */
export class Button {
  private readonly end: WireEnd;
  private readonly contact: Debounce;

  constructor(
    private readonly wire: Wire,
    grid: TickGrid,
  ) {
    this.end = wire.connect('button');
    this.end.pull('up');
    this.contact = new Debounce(grid, () => this.isDown);
    wire.onLevel(() => this.contact.changed());
  }

  /** A finger presses. */
  press(): void {
    this.end.drive(0);
  }

  /** The finger lets go. */
  release(): void {
    this.end.release();
  }

  /** Forgets presses; a finger on it stays. */
  reset(): void {
    this.contact.reset();
  }

  /** The contact itself, without debouncing. */
  get isDown(): boolean {
    return this.wire.level === 0;
  }

  /** What the program sees: 36 ms after a press, 44 ms after a release (rule B1). */
  isPressed(): boolean {
    return this.contact.isOn;
  }

  /** Whether it was pressed since the last question; independent of `takePresses`. */
  wasPressed(): boolean {
    return this.contact.wasOn();
  }

  /** How often it was pressed since the last question; independent of `wasPressed`. */
  takePresses(): number {
    return this.contact.takeCount();
  }
}
