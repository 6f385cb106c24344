import type { TouchKind } from '../boards/board-type';
import { Debounce } from './debounce';
import type { Pin } from '../wires/pin';
import type { TickGrid } from '../tick-grid';

/** A pad that senses a finger: the logo or a touch pin. Debounced like a button (codal-core TouchButton.cpp). */
export class Touch {
  private readonly contact: Debounce;
  private finger = false;
  private currentKind: TouchKind;

  constructor(
    readonly pin: Pin,
    grid: TickGrid,
  ) {
    this.currentKind = pin.type.touch ?? 'capacitive';
    this.contact = new Debounce(grid, () => this.isDown);
    pin.wire.onLevel(() => this.contact.changed());
  }

  /** A finger touches. */
  press(): void {
    this.finger = true;
    this.contact.changed();
  }

  /** The finger leaves. */
  release(): void {
    this.finger = false;
    this.contact.changed();
  }

  /** Forgets touches and the kind of sensing; a finger on the pad stays. */
  reset(): void {
    this.currentKind = this.pin.type.touch ?? 'capacitive';
    this.contact.reset();
  }

  /** Its method of sensing; see `TouchKind`. */
  get kind(): TouchKind {
    return this.currentKind;
  }

  set kind(kind: TouchKind) {
    this.currentKind = kind;
    if (this.pin.mode === 'touch') this.sense();
  }

  /** True while it is touched, without debouncing. A resistive pad also notices a chip that pulls its wire low. */
  get isDown(): boolean {
    if (this.finger) return true;
    return this.currentKind === 'resistive' && this.pin.mode === 'touch' && this.pin.wire.level === 0;
  }

  /** True while it is touched, debounced for the program. Call `pin.acquire('touch')` first. */
  isTouched(): boolean {
    this.sense();
    return this.contact.isOn;
  }

  /** True if it was touched since the last call; independent of `takeTouches`. */
  wasTouched(): boolean {
    return this.contact.wasOn();
  }

  /** Number of touches since the last call; independent of `wasTouched`. */
  takeTouches(): number {
    return this.contact.takeCount();
  }

  private sense(): void {
    this.pin.senseTouch(this.currentKind);
    this.contact.changed();
  }
}
