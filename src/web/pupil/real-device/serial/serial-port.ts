/// <reference types="w3c-web-serial" />
import type { Port } from './port';
import { PutError } from './problem';

/** micro:bit and Calliope mini: both carry ARM's DAPLink (usb.org: 0x0d28 is ARM's, 0x0204 DAPLink's). */
const BOARDS: readonly SerialPortFilter[] = [{ usbVendorId: 0x0d28, usbProductId: 0x0204 }];
/** Baud rate of MicroPython on the micro:bit and most other boards. */
const BAUD = 115_200;

/** The page's line, when the browser has one. */
function serial(): Serial | null {
  return (navigator as { readonly serial?: Serial }).serial ?? null;
}

/**
 * Lets the pupil choose a device and opens its line. Must be called by a click.
 *
 * @param which boards that we know, or any serial line
 * @param free frees the line that the page itself may still hold, before one is opened
 * @returns the open line; `null` when nothing was chosen
 * @throws PutError `frame`, `line-in-use`
 */
export async function chooseSerialPort(which: 'boards' | 'any', free: () => Promise<void>): Promise<Port | null> {
  const line = serial();
  if (line === null) return null;
  let port: SerialPort;
  try {
    port = await line.requestPort(which === 'boards' ? { filters: [...BOARDS] } : {});
  } catch (error) {
    if (error instanceof DOMException && error.name === 'SecurityError') throw new PutError({ kind: 'frame' });
    return null;
  }
  await free();
  try {
    await port.open({ baudRate: BAUD });
  } catch {
    throw new PutError({ kind: 'line-in-use' });
  }
  return portOf(port);
}

/** An open line of the browser as a port. */
export function portOf(port: SerialPort): Port {
  let reader: ReadableStreamDefaultReader<Uint8Array> | null = null;
  let writer: WritableStreamDefaultWriter<Uint8Array> | null = null;
  let isClosing = false;
  return {
    async write(bytes) {
      writer = port.writable?.getWriter() ?? null;
      if (writer === null) throw new Error('The line is closed.');
      try {
        await writer.write(bytes);
      } finally {
        writer.releaseLock();
      }
    },
    async read() {
      // A reader fails for good after a bad byte, while the line goes on: the port then has a new stream.
      while (port.readable !== null && !isClosing) {
        reader ??= port.readable.getReader();
        try {
          const { value, done } = await reader.read();
          if (!done) return value;
        } catch {
          // `port.readable` tells whether the line is gone.
        }
        reader.releaseLock();
        reader = null;
      }
      return null;
    },
    async close() {
      isClosing = true;
      try {
        await reader?.cancel();
        await Promise.resolve(); // the current read releases its lock
        writer?.releaseLock(); // a device that no longer reads must not keep the line open
        await port.close();
      } catch {
        // A device that is gone needs no closing.
      }
    },
  };
}
