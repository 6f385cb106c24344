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
    print(f.name(), f.writable(), repr(f.readline()), repr(f.readline()), repr(f.read()))
f = open('daten.txt')
print(repr(f.read(3)), repr(f.read(8)), repr(f.read()))
f.close()
f = open('daten.txt', 'rb')
buffer = bytearray(4)
print(f.readinto(buffer), buffer, f.read())`;
    expect(linesOf(program, FILES)).toEqual([
      "daten.txt False 'eins\\n' 'zwei\\n' '\\xe4\\xf6\\n'",
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

  it('write text and bytes, count bytes, and take a part of what they are given', () => {
    const program = `
with open('a', 'w') as f:
    print(f.write('hällo\\n'), f.write('x'), f.write('abcdef', 3), f.write('abcdef', 2, 3), f.write('ab', 5, 1))
print(repr(open('a').read()))
f = open('b', 'wb')
print(f.write(b'\\x01\\xff'))
f.close()
print(open('b', 'rb').read())`;
    expect(linesOf(program)).toEqual(['7 1 3 3 0', "'h\\xe4llo\\nxabccde'", '2', "b'\\x01\\xff'"]);
  });

  it('have their last piece only when they are closed: 126 bytes with the name, and what came after it', () => {
    const program = `
import os
f = open('d.txt', 'w')
f.write('abc')
print(repr(open('d.txt').read()), os.size('d.txt'))
f.close()
print(repr(open('d.txt').read()), os.size('d.txt'))
f = open('e.txt', 'w')
f.write('y' * 130)
print(len(open('e.txt').read()), os.size('e.txt'))
f.close()
print(len(open('e.txt').read()), os.size('e.txt'))
with open('g.py', 'w') as f:
    f.write('x = 1')
import g
f = open('h.py', 'w')
f.write('x = 1')
import h
print(g.x, hasattr(h, 'x'))`;
    expect(linesOf(program)).toEqual(["'' 248", "'abc' 3", '119 374', '130 130', '1 False']);
  });

  it('are no iterables, and print as their type', () => {
    const program = `
err(lambda: [line for line in open('daten.txt')])
err(list, open('daten.txt', 'rb'))
err(next, open('daten.txt'))
print(open('daten.txt'), [open('daten.txt', 'rb')])`;
    expect(linesOf(program, FILES)).toEqual([
      "TypeError: 'TextIO' object isn't iterable",
      "TypeError: 'FileIO' object isn't iterable",
      "TypeError: 'TextIO' object isn't an iterator",
      '<TextIO> [<FileIO>]',
    ]);
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
