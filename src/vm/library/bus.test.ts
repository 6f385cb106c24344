import { describe, expect, it } from 'vitest';
import { microbitV2 } from '#board/boards/microbit-v2';
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
err(i2c.read, 0x11, True)
err(i2c.read, 0x10, -2**40)
try:
    i2c.write(0x11, b'')
except OSError as e:
    print(e.args[0])`;
    expect(linesOf(program, {}, chip)).toEqual([
      'OSError: [Errno 19] ENODEV',
      'OSError: [Errno 19] ENODEV',
      'TypeError: object with buffer protocol required',
      "TypeError: can't convert str to int",
      'OSError: [Errno 19] ENODEV',
      'OverflowError: overflow converting long int to machine word',
      '19',
    ]);
  });
});

describe('what spi and serial read into', () => {
  it('is a buffer that may change, of bytes or of words', () => {
    const program = `
import array
words = array.array('H', [0, 0])
spi.init(mosi=pin15, miso=pin15)
spi.write_readinto(b'\\x01\\x02\\x03\\x04', words)
print(words, len(spi.read(True)))
for buffer in ('ab', b'ab', memoryview(b'ab'), [1, 2]):
    err(spi.write_readinto, b'ab', buffer)
    err(uart.readinto, buffer)
err(uart.readinto, bytearray(2), None)
err(uart.readline, 'x')`;
    const refused = 'TypeError: object with buffer protocol required';
    expect(linesOf(program)).toEqual([
      "array('H', [0, 0]) 1",
      ...Array.from({ length: 8 }, () => refused),
      "TypeError: can't convert NoneType to int",
      "TypeError: can't convert str to int",
    ]);
  });
});

describe('i2c on other pins', () => {
  it('reaches the chip there, and the usual ones again after a plain init', () => {
    const there = (bench: Bench): void => {
      const { board } = bench;
      const answer = (byte: number) => ({ write: () => undefined, read: () => Uint8Array.of(byte) });
      board.i2c.attach(0x10, answer(1));
      board.i2c.attach(0x10, answer(2), { scl: board.wire('P1'), sda: board.wire('P2') });
    };
    const program = `
print(i2c.read(0x10, 1))
i2c.init(freq=400000, sda=pin2, scl=pin1)
print(i2c.read(0x10, 1), pin1.get_mode(), pin20.get_mode())
i2c.init(100000, pin8, pin9)
err(i2c.read, 0x10, 1)
print(i2c.scan())
i2c.init()
print(i2c.read(0x10, 1))
err(i2c.init, 100000, 5)
err(i2c.init, 'fast')`;
    const newest = { firmware: microbitV2.firmwares[1] };
    expect(linesOf(program, {}, there, newest)).toEqual([
      "b'\\x01'",
      "b'\\x02' unused i2c",
      'OSError: [Errno 19] ENODEV',
      '[]',
      "b'\\x01'",
      'TypeError: expecting a pin',
      "TypeError: can't convert str to int",
    ]);
  });
});

describe('i2c.init with other pins on v2.1.2', () => {
  it('looks whether they are pins, and stays where it is', () => {
    const answer = { write: () => undefined, read: () => Uint8Array.of(7) };
    const program = `
i2c.init(freq=400000, sda=pin2, scl=pin1)
print(i2c.read(0x10, 1))
err(i2c.init, 100000, 5)`;
    expect(linesOf(program, {}, ({ board }) => void board.i2c.attach(0x10, answer))).toEqual([
      "b'\\x07'",
      'TypeError: expecting a pin',
    ]);
  });
});

describe('spi in Python', () => {
  /** Answers each byte with the one before, 0xa5 first. */
  const attachEcho = (bench: Bench): void => {
    let last = 0xa5;
    const { board } = bench;
    board.spi.attach(
      { clock: board.wire('P13'), mosi: board.wire('P15'), miso: board.wire('P14') },
      {
        transfer: (sent) => {
          const answer = last;
          last = sent;
          return answer;
        },
      },
    );
  };

  it('writes, reads and does both at once on pins 13, 14 and 15', () => {
    const program = `
spi.init()
print(spi.write(b'\\x01\\x02'), pin13.get_mode())
print(spi.read(2), spi.read(2, 0x77), spi.read(0))
buf = bytearray(3)
print(spi.write_readinto(b'abc', buf), buf)`;
    expect(linesOf(program, {}, attachEcho)).toEqual([
      'None spi',
      "b'\\x02\\x00' b'\\x00w' b''",
      "None bytearray(b'wab')",
    ]);
  });

  it('takes 8 µs a byte at 1 MHz and 64 µs at 125 kHz', () => {
    const program = `
import time
def us(f, *a):
    t = time.ticks_us()
    f(*a)
    return time.ticks_us() - t
spi.init(baudrate=1000000)
fast = us(spi.write, bytes(1000)) - us(spi.write, b'')
spi.init(baudrate=100)
print(fast, us(spi.write, bytes(100)) - us(spi.write, b''))`;
    expect(linesOf(program)).toEqual(['8000 6400']);
  });

  it('refuses mistakes in the words of the device', () => {
    const program = `
err(spi.write, b'1')
err(spi.read, 1)
err(spi.write_readinto, b'1', bytearray(1))
err(spi.init, sclk=pin3)
err(spi.init, mosi=pin_logo)
err(spi.init, bits=9)
err(spi.write, b'1')
spi.init(sclk=pin16)
err(spi.write_readinto, b'12', bytearray(1))
err(spi.read, -1)
err(spi.write, 5)
err(pin16.write_digital, 1)
print(pin13.get_mode())`;
    expect(linesOf(program)).toEqual([
      'ValueError: SPI not initialised',
      'ValueError: SPI not initialised',
      'ValueError: SPI not initialised',
      'ValueError: Pin 3 in display mode',
      'TypeError: expecting a pin',
      'OSError: -1001',
      'ValueError: SPI not initialised',
      'ValueError: write and read buffers must be the same length',
      'ValueError: invalid number of bytes',
      'TypeError: object with buffer protocol required',
      'ValueError: Pin 16 in spi mode',
      'spi',
    ]);
  });
});

describe('uart on pins', () => {
  it('talks to a chip at its speed; what the program prints goes there too and not to USB', () => {
    const sent: string[] = [];
    const run = play(
      `
from microbit import *
print('usb')
uart.init(baudrate=9600, tx=pin0, rx=pin1)
print('hi')
uart.write(b'\\x01\\xff')
sleep(100)
data = uart.read()
line = uart.readline()
uart.init(115200)
print(data, line, uart.any())`,
      {},
      ({ board }) => {
        board.wire('P0').onSerial(({ bytes, baud }) => sent.push(`${[...bytes].join(' ')} at ${baud}`));
      },
    );
    run
      .until(50)
      .bench.board.wire('P1')
      .serial({ bytes: Uint8Array.of(65, 66), baud: 9600 });
    expect(run.until(1000).printed()).toBe("usb\nb'AB' None False\n");
    expect(sent.join(', ').replace(/, /g, ' | ')).toContain('1 255 at 9600');
    expect(sent.map((frame) => frame.split(' at ')[0]).join(' ')).toContain('104 105');
  });

  it('waits up to 2 ms for the next byte at 9600 baud, not at all for the first', () => {
    const run = play(`
from microbit import *
uart.init(9600, tx=pin0, rx=pin1)
sleep(20)
data = [uart.read(), uart.read(2)]
uart.init(115200)
print(data)`);
    const wire = run.until(10).bench.board.wire('P1');
    wire.serial({ bytes: Uint8Array.of(1, 2), baud: 9600 });
    run.until(21);
    wire.serial({ bytes: Uint8Array.of(3), baud: 9600 });
    expect(run.until(500).printed()).toBe("[b'\\x01\\x02\\x03', None]\n");
  });

  it('takes 1.04 ms a byte at 9600 baud', () => {
    expect(linesOf('uart.init(9600, tx=pin0)\nt = took(uart.write, bytes(100))\nuart.init(115200)\nprint(t)')).toEqual([
      '104',
    ]);
  });

  it('refuses mistakes in the words of the device', () => {
    const program = `
err(uart.init, 9600, tx=5)
err(uart.init, 9600, pins=(pin0,))
err(uart.init, 9600, pins=pin0)
err(uart.init, 'fast')
err(uart.init, 9600, tx=pin_logo)
err(uart.write, 5)
uart.init(9600, bits=7, parity=uart.ODD, stop=2)
print(uart.ODD, uart.EVEN)`;
    expect(linesOf(program)).toEqual([
      'TypeError: expecting a pin',
      'ValueError: requested length 2 but object has length 1',
      "TypeError: object 'MicroBitTouchPin' isn't a tuple or list",
      "TypeError: can't convert str to int",
      'TypeError: expecting a pin',
      'TypeError: object with buffer protocol required',
      '1 0',
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
