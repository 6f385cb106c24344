import { describe, expect, it } from 'vitest';
import { createBench } from '../testing/bench';

describe('the serial line', () => {
  it('U1: goes to USB at 115200 baud after a start', () => {
    const { uart } = createBench().board;
    expect([uart.pins.tx, uart.pins.rx, uart.baud]).toEqual([null, null, 115_200]);
    expect(uart.byteUs).toBeCloseTo(86.8, 1);
  });

  it('U2: on pins it rests high, and its bytes do not move the level', () => {
    const { board, record } = createBench();
    const sent: string[] = [];
    board.wire('P0').onSerial(({ bytes, baud }) => sent.push(`${bytes.join(' ')} at ${baud}`));
    board.uart.init(9600, { tx: board.pin('pin0'), rx: board.pin('pin1') });
    expect(board.wire('P0').level).toBe(1);
    const seen = record('P0');
    board.uart.send(Uint8Array.of(72, 105));
    expect([sent, seen]).toEqual([['72 105 at 9600'], []]);
    expect(board.pin('pin0').mode).toBe('unused');
  });

  it('U3: receives on its pin what comes at its own speed, and nothing else', () => {
    const { board } = createBench();
    const { uart } = board;
    uart.init(9600, { tx: null, rx: board.pin('pin1') });
    board.wire('P1').serial({ bytes: Uint8Array.of(1, 10, 3), baud: 9600 });
    board.wire('P1').serial({ bytes: Uint8Array.of(4), baud: 115_200 });
    board.wire('P2').serial({ bytes: Uint8Array.of(5), baud: 9600 });
    expect([uart.waiting, uart.lineLength]).toEqual([3, 2]);
    expect([uart.take(), uart.take(), uart.take(), uart.take()]).toEqual([1, 10, 3, undefined]);
  });

  it('U3: keeps up to 128 bytes; what comes then is lost', () => {
    const { board } = createBench();
    board.uart.init(9600, { tx: null, rx: board.pin('pin1') });
    board.wire('P1').serial({ bytes: new Uint8Array(200), baud: 9600 });
    expect(board.uart.waiting).toBe(128);
  });

  it('U4: a speed that the firmware does not know becomes 115200', () => {
    const { board } = createBench();
    const got = [9600, 31_250, 1200, 4800, 19_200, 460_800, 12_345, 0, -1].map((wish) => {
      board.uart.init(wish, { tx: null, rx: null });
      return board.uart.baud;
    });
    expect(got).toEqual([9600, 31_250, ...Array.from({ length: 7 }, () => 115_200)]);
  });

  it('U5: back on USB it hears the pin no more', () => {
    const { board } = createBench();
    board.uart.init(9600, { tx: board.pin('pin0'), rx: board.pin('pin1') });
    board.uart.init(9600, { tx: null, rx: null });
    board.wire('P1').serial({ bytes: Uint8Array.of(1), baud: 9600 });
    board.uart.send(Uint8Array.of(1));
    expect(board.uart.waiting).toBe(0);
  });
});
