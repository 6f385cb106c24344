import { describe, expect, it } from 'vitest';
import type { Bench } from '#board/testing/bench';
import { linesOf, play } from './testing/play';

describe('i2c in Python', () => {
  const written: number[][] = [];
  const chip = (bench: Bench): void => {
    written.length = 0;
    bench.board.i2c.attach(0x10, {
      write: (bytes) => written.push([...bytes]),
      read: (count) => Uint8Array.from({ length: count }, (_, i) => i + 1),
    });
  };

  it('writes bytes, bytearray, memoryview, array and text as the device does', () => {
    const program = `
import array
i2c.write(0x10, b'\\x00\\x01')
i2c.write(0x10, bytearray([1, 2]), True)
i2c.write(0x10, memoryview(b'xyz'))
i2c.write(addr=0x10, buf=array.array('H', [1, 2]), repeat=False)
i2c.write(0x10, 'ab')
i2c.write(0x10, b'')`;
    linesOf(program, {}, chip);
    expect(written).toEqual([[0, 1], [1, 2], [120, 121, 122], [1, 0, 2, 0], [97, 98], []]);
  });

  it('reads bytes and finds the one chip', () => {
    expect(linesOf('print(i2c.read(0x10, 3), i2c.scan())', {}, chip)).toEqual(["b'\\x01\\x02\\x03' [16]"]);
  });

  it('raises OSError 19 when nobody answers, TypeError for a list', () => {
    const program = `
err(i2c.write, 0x11, b'1')
err(i2c.read, 0x11, 1)
err(i2c.write, 0x10, [1, 2])
err(i2c.write, 'a', b'1')
err(i2c.init, 400000, pin1)
try:
    i2c.write(0x11, b'')
except OSError as e:
    print(e.args[0])`;
    expect(linesOf(program, {}, chip)).toEqual([
      'OSError: [Errno 19] ENODEV',
      'OSError: [Errno 19] ENODEV',
      'TypeError: object with buffer protocol required',
      "TypeError: can't convert str to int",
      'NotImplementedError: microbit.i2c on other pins than pin20 (sda) and pin19 (scl) is not simulated yet',
      '19',
    ]);
  });
});

describe('uart in Python', () => {
  it('reads what was typed and writes to the console', () => {
    const run = play(`
from microbit import *
sleep(100)
print(uart.any(), uart.readline(), uart.read(1), uart.read(), uart.read(), uart.readline(), uart.any())
uart.write('hi')
uart.init(baudrate=115200)
`);
    run.until(50).vm.feed('abc\nde');
    expect(run.until(1000).printed()).toBe("True b'abc\\n' b'd' b'e' None None False\nhi");
  });
});
