import type { Value } from './syscall';

// The kinds of values at the boundary, as the port of MicroPython to WebAssembly numbers them (ports/webassembly/proxy_c.c).
const FROM_PYTHON = { none: 1, bool: 2, int: 3, float: 4, str: 5 } as const;
const TO_PYTHON = { null: 1, bool: 2, int: 3, double: 4, str: 5, object: 7 } as const;

// One of each for all texts: creating one costs more than a short text.
const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** Up to this length a text is put together byte by byte. Chosen: below it that is faster. */
const SHORT_BYTES = 24;

/** Up to this length a text is written byte by byte. Chosen, likewise. */
const MOST_SHORT = 80;

function isAscii(text: string): boolean {
  for (let index = 0; index < text.length; index++) if (text.charCodeAt(index) > 0x7f) return false;
  return true;
}

/** Longer values are cut: they are still more than the board's memory can take. Chosen, several times 64 KiB. */
const MOST_CHARACTERS = 256 * 1024;

/** The bytes of one value at the boundary: kind and two words. */
export const VALUE_BYTES = 12;

/** The firmware's memory. It has a fixed size (the firmware is never given more), so the views stay valid. */
export class Memory {
  readonly bytes: Uint8Array;
  private readonly view: DataView;

  constructor(
    buffer: ArrayBuffer,
    private readonly malloc: (bytes: number) => number,
  ) {
    this.bytes = new Uint8Array(buffer);
    this.view = new DataView(buffer);
  }

  word(address: number): number {
    return this.view.getInt32(address, true);
  }

  half(address: number): number {
    return this.view.getUint16(address, true);
  }

  byte(address: number): number {
    return this.bytes[address] ?? 0;
  }

  double(address: number): number {
    return this.view.getFloat64(address, true);
  }

  setWord(address: number, value: number): void {
    this.view.setInt32(address, value, true);
  }

  /** The UTF-8 text of this many bytes. */
  text(address: number, length: number): string {
    return this.shortAscii(address, length) ?? decoder.decode(this.bytes.subarray(address, address + length));
  }

  /** A short text of ASCII: the decoder's own overhead costs more. `null`: it is neither. */
  private shortAscii(address: number, length: number): string | null {
    if (length > SHORT_BYTES) return null;
    let text = '';
    for (let index = 0; index < length; index++) {
      const byte = this.bytes[address + index] ?? 0;
      if (byte > 0x7f) return null;
      text += String.fromCharCode(byte);
    }
    return text;
  }

  /** The UTF-8 text up to the next zero byte. */
  textUntilZero(address: number): string {
    return this.text(address, this.bytes.indexOf(0, address) - address);
  }

  /** Writes ASCII characters and a closing zero byte. Returns how many characters. */
  putAscii(address: number, text: string): number {
    for (let index = 0; index < text.length; index++) this.bytes[address + index] = text.charCodeAt(index);
    this.bytes[address + text.length] = 0;
    return text.length;
  }

  /** Puts a text and a closing zero byte into newly allocated memory. */
  allocateText(text: string): { readonly address: number; readonly length: number } {
    if (text.length <= MOST_SHORT && isAscii(text)) {
      const address = this.malloc(text.length + 1);
      return { address, length: this.putAscii(address, text) };
    }
    const bytes = encoder.encode(text.slice(0, MOST_CHARACTERS));
    const address = this.malloc(bytes.length + 1);
    this.bytes.set(bytes, address);
    this.bytes[address + bytes.length] = 0;
    return { address, length: bytes.length };
  }

  /** Reads a value that Python passes. Anything except numbers, text, bool and None reads as null. */
  read(address: number): Value {
    const view = this.view;
    switch (view.getInt32(address, true)) {
      case FROM_PYTHON.bool:
        return view.getInt32(address + 4, true) !== 0;
      case FROM_PYTHON.int:
        return view.getInt32(address + 4, true);
      case FROM_PYTHON.float:
        return view.getFloat64(address + 4, true);
      case FROM_PYTHON.str:
        return this.text(view.getInt32(address + 8, true), view.getInt32(address + 4, true));
      default:
        return null;
    }
  }

  /** Writes a value for Python. Whole numbers of 32 bits become ints, other numbers floats. */
  write(value: Value, address: number): void {
    const view = this.view;
    if (typeof value === 'number') {
      if ((value | 0) === value) {
        view.setInt32(address, TO_PYTHON.int, true);
        view.setInt32(address + 4, value, true);
      } else {
        view.setInt32(address, TO_PYTHON.double, true);
        view.setFloat64(address + 4, value, true);
      }
    } else if (value === null) {
      view.setInt32(address, TO_PYTHON.null, true);
    } else if (typeof value === 'boolean') {
      view.setInt32(address, TO_PYTHON.bool, true);
      view.setInt32(address + 4, Number(value), true);
    } else {
      const text = this.allocateText(value);
      view.setInt32(address, TO_PYTHON.str, true);
      view.setInt32(address + 4, text.length, true);
      view.setInt32(address + 8, text.address, true);
    }
  }

  /** Writes a reference to a host object: `_hal` or one of its functions. */
  writeReference(reference: number, address: number): void {
    this.setWord(address, TO_PYTHON.object);
    this.setWord(address + 4, reference);
  }
}
