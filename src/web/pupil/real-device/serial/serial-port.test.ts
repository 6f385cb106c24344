/// <reference types="w3c-web-serial" />
import { describe, expect, it } from 'vitest';

import { portOf } from './serial-port';

/** A line of the browser with a device that takes nothing. As the browser's it closes only when nobody holds its streams. */
function deafLine() {
  const readable = new ReadableStream<Uint8Array>();
  const writable = new WritableStream<Uint8Array>({ write: () => new Promise(() => undefined) });
  const line = { readable, writable, isOpen: true };
  const close = (): Promise<void> => {
    if (readable.locked || writable.locked) return Promise.reject(new TypeError('locked'));
    line.isOpen = false;
    return Promise.resolve();
  };
  return Object.assign(line, { close });
}

describe('a serial line of the browser', () => {
  it('is closed also when the device takes nothing any more, so that it can be opened again', async () => {
    const line = deafLine();
    const port = portOf(line as unknown as SerialPort);
    const came = port.read();
    void port.write(Uint8Array.of(1)).catch(() => undefined);
    await port.close();
    expect(line.isOpen).toBe(false);
    expect(await came).toBeNull();
  });
});
