import type { Stop } from '#core/stop';
import type { Pin } from './pin';

/** The pins of the serial line, or `null` for the USB socket; each direction separately. */
export interface UartPins {
  readonly tx: Pin | null;
  readonly rx: Pin | null;
}

const START_BAUD = 115_200; // micropython-microbit-v2 README: the REPL's speed
const BITS_PER_BYTE = 10; // start bit, eight data bits, stop bit; bits, parity and stop have no effect on the device
const BUFFER_BYTES = 128; // micropython-microbit-v2 main.cpp: setRxBufferSize
const ON_USB: UartPins = { tx: null, rx: null };
/** codal-nrf52 NRF52Serial.cpp, setBaudrate: every other speed becomes 115200, also those that the chip itself knows. */
const BAUDS: ReadonlySet<number> = new Set([9600, 31_250, 38_400, 57_600, 115_200, 230_400, 921_600, 1_000_000]);

/**
 * The one serial line of the microcomputer. It carries `print` and the REPL over USB, until a program puts it on pins.
 * Then both directions leave the USB socket, or only the direction whose pin was given.
 */
export class Uart {
  private currentPins = ON_USB;
  private currentBaud = START_BAUD;
  private received: number[] = [];
  private stopListening: Stop = () => undefined;

  get pins(): UartPins {
    return this.currentPins;
  }

  get baud(): number {
    return this.currentBaud;
  }

  /** Duration of a byte on the line, in µs (may be a fraction). */
  get byteUs(): number {
    return (BITS_PER_BYTE * 1_000_000) / this.currentBaud;
  }

  /** Puts the line on pins or back to USB. Needs no mode and changes none, as on the device. */
  init(wishBaud: number, pins: UartPins): void {
    this.stopListening();
    this.currentPins = pins;
    this.currentBaud = BAUDS.has(wishBaud) ? wishBaud : START_BAUD;
    pins.tx?.holdLevel(1); // the line rests high
    if (!pins.rx) return;
    pins.rx.holdInput('up');
    this.stopListening = pins.rx.wire.onSerial(({ bytes, baud }) => {
      if (baud === this.currentBaud) this.receive(bytes); // at another speed nothing sensible arrives (rule U3)
    });
  }

  /** Back on USB at 115200 baud, with nothing received. */
  reset(): void {
    this.init(START_BAUD, ON_USB);
    this.received = [];
  }

  /** Sends bytes on the pin for sending; without such a pin nothing happens. Let `byteUs` pass for each byte first. */
  send(bytes: Uint8Array): void {
    this.currentPins.tx?.sendSerial({ bytes, baud: this.currentBaud });
  }

  /** Number of bytes that have arrived on the pin for receiving and wait. */
  get waiting(): number {
    return this.received.length;
  }

  /** Number of them that make up the next line with its newline; all of them if there is no newline yet. */
  get lineLength(): number {
    const end = this.received.indexOf(0x0a);
    return end < 0 ? this.waiting : end + 1;
  }

  /** Takes the next byte that has arrived, or `undefined`. */
  take(): number | undefined {
    return this.received.shift();
  }

  private receive(bytes: Uint8Array): void {
    for (const byte of bytes) if (this.received.length < BUFFER_BYTES) this.received.push(byte);
  }
}
