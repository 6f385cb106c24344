import { Debounce } from './debounce';
import type { TickGrid } from '../tick-grid';
import type { Wire, WireEnd } from '../wires/wire';

/**
 * A push button between a wire and ground, with the pull-up of the board. A chip that pulls the wire low also presses
 * it, as on the device.
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

  /** Lifts the finger. */
  release(): void {
    this.end.release();
  }

  /** Forgets presses; a finger on the button stays. */
  reset(): void {
    this.contact.reset();
  }

  /** True while the contact is closed, without debouncing. */
  get isDown(): boolean {
    return this.wire.level === 0;
  }

  /** The debounced state for the program: true 36 ms after a press, false 44 ms after a release (rule B1). */
  isPressed(): boolean {
    return this.contact.isOn;
  }

  /** True if it was pressed since the last call; independent of `takePresses`. */
  wasPressed(): boolean {
    return this.contact.wasOn();
  }

  /** Number of presses since the last call; independent of `wasPressed`. */
  takePresses(): number {
    return this.contact.takeCount();
  }
}
