import { describe, expect, it } from 'vitest';
import { microbitV2 } from '#board/boards/microbit-v2';
import { linesOf } from './testing/play';

const FILES = { 'daten.txt': 'eins\nzwei\näö\n' };

describe('files in Python', () => {
  it('are listed without the libraries', () => {
    const program = `
import os
print(sorted(os.listdir()), os.size('daten.txt'), os.stat('daten.txt')[6])
print(os.uname().sysname, os.uname().machine)
os.remove('daten.txt')
print(os.listdir())`;
    expect(linesOf(program, FILES)).toEqual([
      "['daten.txt', 'main.py'] 15 15",
      'microbit micro:bit with nRF52833',
      "['main.py']",
    ]);
  });

  it('read by lines, characters and bytes', () => {
    const program = `
with open('daten.txt') as f:
    print(f.name(), f.writable(), repr(f.readline()), [line for line in f], repr(f.read()))
f = open('daten.txt')
print(repr(f.read(3)), repr(f.read(8)), repr(f.read()))
f.close()
f = open('daten.txt', 'rb')
buffer = bytearray(4)
print(f.readinto(buffer), buffer, f.read())`;
    expect(linesOf(program, FILES)).toEqual([
      "daten.txt False 'eins\\n' ['zwei\\n', '\\xe4\\xf6\\n'] ''",
      "'ein' 's\\nzwei\\n\\xe4' '\\xf6\\n'",
      "4 bytearray(b'eins') b'\\nzwei\\n\\xc3\\xa4\\xc3\\xb6\\n'",
    ]);
  });

  it('read a line that ends inside a sign: unchecked before MicroPython 1.20', () => {
    const program = `
f = open('daten.txt')
f.read(10)
try:
    print(len(f.readline(1)), len(f.readline(2)))
except UnicodeError:
    print('UnicodeError')`;
    expect(linesOf(program, FILES)).toEqual(['1 1']);
    expect(linesOf(program, FILES, undefined, { firmware: microbitV2.firmwares[1] })).toEqual(['UnicodeError']);
  });

  it('read into what may change, words too', () => {
    const program = `
import array
words = array.array('H', [0, 0])
print(open('daten.txt', 'rb').readinto(words), words)
err(open('daten.txt').readinto, b'1234')
err(open('daten.txt').readinto, memoryview(b'1234'))
err(open, 'daten.txt', None)`;
    expect(linesOf(program, FILES)).toEqual([
      "4 array('H', [26981, 29550])",
      'TypeError: object with buffer protocol required',
      'TypeError: object with buffer protocol required',
      "TypeError: can't convert 'NoneType' object to str implicitly",
    ]);
  });

  it('write text and bytes', () => {
    const program = `
with open('a', 'w') as f:
    print(f.write('hällo\\n'), f.write('x'))
print(repr(open('a').read()))
f = open('b', 'wb')
print(f.write(b'\\x01\\xff'))
f.close()
print(open('b', 'rb').read())`;
    expect(linesOf(program)).toEqual(['6 1', "'h\\xe4llo\\nx'", '2', "b'\\x01\\xff'"]);
  });

  it('raise the errors of the device', () => {
    const program = `
import os
err(os.remove, 'x')
err(os.size, 'x')
err(open, 'x')
err(open, 'x', 'q')
err(open, 'x', 'rw')
err(open, 'a' * 121, 'w')
f = open('daten.txt')
err(f.write, 'a')
f.close()
err(f.read)
f = open('a', 'w')
err(f.read)`;
    expect(linesOf(program, FILES)).toEqual([
      'OSError: [Errno 2] ENOENT',
      'OSError: [Errno 2] ENOENT',
      'OSError: [Errno 2] ENOENT',
      'ValueError: illegal mode',
      'ValueError: illegal mode',
      'OSError: [Errno 2] ENOENT',
      'OSError: [Errno 9] EBADF',
      'ValueError: I/O operation on closed file',
      'OSError: [Errno 9] EBADF',
    ]);
  });

  it('fill up after about 24 kB with OSError 28', () => {
    const program = `
n = 0
try:
    with open('big', 'w') as f:
        while True:
            f.write('x' * 100)
            n += 100
except OSError as e:
    print(e.args[0], 23000 < n < 24500)`;
    expect(linesOf(program)).toEqual(['28 True']);
  });
});
