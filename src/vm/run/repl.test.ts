import { describe, expect, it } from 'vitest';
import { ConsolePort } from './console-port';
import { LineEditor } from './line-editor';
import { Repl } from './repl';
import { wantsMore } from './repl-input';
import { deviceWith, type Device, type ProgramOptions } from './testing/run-program';

const SECOND = 1_000_000;
const GREETING =
  'MicroPython v1.18 on 2023-10-30; micro:bit v2.1.2 with nRF52833\r\nType "help()" for more information.\r\n>>> ';

/** A program that has ended, and what the REPL answers to input after it. */
function replAfter(program: string, options: ProgramOptions = {}): Device & { type: (text: string) => string } {
  const device = deviceWith(program, options);
  device.vm.resume(60 * SECOND);
  // An error takes its time on the display.
  device.vm.resume(180 * SECOND);
  return {
    ...device,
    type: (text) => {
      const before = device.console().length;
      device.vm.feed(text);
      const untilUs = device.clock.nowUs + 5 * SECOND;
      while (device.clock.nowUs < untilUs) device.vm.resume(untilUs);
      return device.console().slice(before);
    },
  };
}

describe('the REPL', () => {
  it('stays silent until somebody types, when nobody asked for it', () => {
    const { vm, clock, console, type } = replAfter('print(1)');
    vm.resume(clock.nowUs + SECOND);
    expect([console(), vm.isInRepl]).toEqual(['1\n', false]);
    expect(type('\r')).toBe(`${GREETING}\r\n>>> `);
    expect(vm.isInRepl).toBe(true);
  });

  it('greets at once when it is asked to, as the device does', () => {
    const { vm, clock, console } = deviceWith('print(1)', { repl: 'at-once' });
    vm.resume(SECOND);
    expect(vm.ended?.kind).toBe('finished');
    vm.resume(clock.nowUs + SECOND);
    expect(console()).toBe(`1\n${GREETING}`);
  });

  it('comes back at the very end of the program, and lets time pass after it', () => {
    const { vm, clock } = deviceWith('from microbit import sleep\nsleep(100)');
    vm.resume(SECOND);
    expect(clock.nowUs).toBeLessThan(101_000);
    vm.resume(SECOND);
    expect(clock.nowUs).toBe(SECOND);
  });

  it('knows the globals of the program, prints what an expression gives, and keeps it as _', () => {
    const { type } = replAfter('x = 20');
    expect(type('x + 1\r')).toBe(`${GREETING}x + 1\r\n21\r\n>>> `);
    expect(type('_ * 2\r')).toBe('_ * 2\r\n42\r\n>>> ');
    expect(type('y = 3\r')).toBe('y = 3\r\n>>> ');
    expect(type('None\r')).toBe('None\r\n>>> ');
  });

  it('shows an error with its place in <stdin>, and goes on', () => {
    const { vm, type } = replAfter('');
    type('\r');
    expect(type('1/0\r')).toBe(
      '1/0\r\nTraceback (most recent call last):\r\n  File "<stdin>", line 1, in <module>\r\nZeroDivisionError: divide by zero\r\n>>> ',
    );
    expect(type('x =\r')).toContain('SyntaxError: invalid syntax\r\n');
    expect(vm.ended?.kind).toBe('finished');
  });

  it('asks for the rest of a block and indents it', () => {
    const { type } = replAfter('');
    type('\r');
    expect(type('for i in range(2):\rprint(i)\r\b\r')).toBe(
      'for i in range(2):\r\n...     print(i)\r\n...     \b\b\b\b\x1b[K\r\n0\r\n1\r\n>>> ',
    );
  });

  it('stops what runs at Ctrl-C, and a line that is typed', () => {
    const { type, clock, vm } = replAfter('');
    type('\r');
    expect(type('while True: pass\r\r')).toBe('while True: pass\r\n... \r\n');
    vm.resume(clock.nowUs + SECOND);
    expect(type('\x03')).toContain('KeyboardInterrupt: \r\n>>> ');
    expect(type('abc\x03')).toBe('abc\r\n>>> ');
    expect(type('if 1:\r\x03')).toBe('if 1:\r\n...     \r\n>>> ');
  });

  it('runs what is pasted between Ctrl-E and Ctrl-D, without indenting; Ctrl-C drops it', () => {
    const { type } = replAfter('');
    type('\r');
    expect(type('\x05a = 1\r\nfor i in range(2):\n    a += i\ra\x04')).toBe(
      '\r\npaste mode; Ctrl-C to cancel, Ctrl-D to finish\r\n=== a = 1\r\n=== for i in range(2):\r\n===     a += i\r\n=== a\r\n2\r\n>>> ',
    );
    expect(type('\x05b = 1\r\x03')).toContain('=== b = 1\r\n=== \r\n>>> ');
    expect(type('b\r')).toContain('NameError');
  });

  it('completes names with Tab, lists several, and indents after a space', () => {
    const { type } = replAfter('from microbit import *\nverylong = 1\nverylate = 2');
    type('\r');
    expect(type('verylo\t\r')).toBe('verylong\r\n1\r\n>>> ');
    expect(type('ver\t')).toBe('veryl');
    expect(type('\t\x03')).toBe('\r\nverylate        verylong\r\n>>> veryl\r\n>>> ');
    expect(type('display.scr\t')).toBe('display.scroll');
    expect(type('\x03imp\t')).toBe('\r\n>>> import ');
    expect(type('\x03if 1: \t')).toBe('\r\n>>> if 1:     ');
  });

  it('talks to tools in raw mode', () => {
    const { type } = replAfter('');
    expect(type('\x01')).toBe(`${GREETING}\r\nraw REPL; CTRL-B to exit\r\n>`);
    expect(type('print(1)\x04')).toBe('OK1\r\n\x04\x04>');
    expect(type('x\x04')).toBe(
      "OK\x04Traceback (most recent call last):\r\n  File \"<stdin>\", line 1, in <module>\r\nNameError: name 'x' isn't defined\r\n\x04>",
    );
    expect(type('\x05A\x01')).toBe('R\x00>');
    expect(type('\x02')).toBe(`\r\n${GREETING}`);
  });

  it('starts main.py anew at Ctrl-D, with the files that were written and the time running on', () => {
    const { vm, type, console } = replAfter('import time, os\nprint(time.ticks_ms() > 1000, os.listdir())');
    type('f = open("a", "w"); n = f.write("x")\r');
    expect(type('\x04')).toContain("\r\nMPY: soft reboot\r\nTrue ['main.py', 'a']\n");
    expect(vm.ended?.kind).toBe('finished');
    expect(vm.isInRepl).toBe(false);
    type('n\r');
    expect(console()).toContain('NameError');
  });

  it('lets Ctrl-C interrupt the program that Ctrl-D has begun anew', () => {
    const { vm, type } = replAfter('import os\nfrom microbit import sleep\nwhile "a" in os.listdir(): sleep(10)');
    type('f = open("a", "w"); n = f.write("x")\r');
    expect(type('\x04')).toContain('MPY: soft reboot');
    expect(vm.ended).toBeNull();
    expect(type('\x03')).toContain('KeyboardInterrupt');
    expect(vm.ended?.kind).toBe('stopped');
  });

  it('reboots at sys.exit() too, and leaves main.py alone for a tool in raw mode', () => {
    const { type } = replAfter('print("main")');
    type('\r');
    expect(type('import sys\r')).toBe('import sys\r\n>>> ');
    expect(type('sys.exit()\r')).toBe('sys.exit()\r\nMPY: soft reboot\r\nmain\n');
    type('\x01');
    expect(type('\x04')).toBe('OK\r\nMPY: soft reboot\r\nraw REPL; CTRL-B to exit\r\n>');
  });

  it('is all there is when the board has no main.py; the names of microbit are there', () => {
    const { vm, type } = replAfter('', { main: false });
    expect(vm.ended?.kind).toBe('finished');
    expect(type('button_a\r')).toContain('<MicroBitButton>');
  });

  it('goes on when the heap is full', () => {
    const { type } = replAfter('box = []\nwhile True:\n    box.append(bytearray(8))');
    expect(type('len(box) > 1000\r')).toContain('>>> ');
    type('box = None\r');
    expect(type('1 + 1\r')).toContain('2\r\n>>> ');
  });

  it('shows the error of a timer that was started in it', () => {
    const { type } = replAfter('from microbit import *\ndef f(): nothing');
    expect(type('t = run_every(f, ms=100)\r')).toContain("NameError: name 'nothing' isn't defined");
    expect(type('1 + 1\r')).toContain('2\r\n>>> ');
  });

  it('ends the timers of the program and leaves its music on', () => {
    const { board, console, vm, clock } = replAfter(
      'from microbit import *\nimport music\nrun_every(lambda: print("tick"), ms=100)\nmusic.pitch(440, wait=False)',
    );
    vm.resume(clock.nowUs + SECOND);
    expect(console()).toBe('');
    expect(board.music.frequencyHz).toBeCloseTo(440, 0);
  });

  it('helps', () => {
    const { type } = replAfter('');
    expect(type('help()\r')).toContain('Ctrl-D');
    expect(type("help('modules')\r")).toMatch(/machine +\S+ +.*\r\n/);
  });
});

describe('Ctrl-C on the serial line', () => {
  const stopped = (program: string): Device => {
    const device = deviceWith(program);
    device.vm.resume(SECOND);
    device.vm.feed('\x03');
    device.vm.resume(2 * SECOND);
    return device;
  };

  it.each([
    ['spins', 'while True: pass'],
    ['sleeps', 'from microbit import *\nsleep(100000)'],
    ['prints', 'while True: print(1)'],
    ['waits for input', 'input("? ")'],
    ['scrolls', 'from microbit import *\ndisplay.scroll("hello", loop=True)'],
  ])('stops a program that %s', (_, program) => {
    const { vm, console } = stopped(program);
    expect(vm.ended?.kind).toBe('stopped');
    expect(console()).toContain('KeyboardInterrupt: \n');
  });

  it('is a byte like any other after micropython.kbd_intr(-1)', () => {
    const { vm, console } = stopped(
      'import micropython\nfrom microbit import *\nmicropython.kbd_intr(-1)\nwhile not uart.any(): pass\nprint(uart.read())\nsleep(9999)',
    );
    expect(vm.ended).toBeNull();
    expect(console()).toBe("b'\\x03'\n");
  });

  it('skips the error that scrolls over the display', () => {
    const { vm, board, clock } = deviceWith('x', { repl: 'at-once' });
    vm.resume(SECOND);
    vm.resume(3 * SECOND);
    expect(board.display.isAnimating).toBe(true);
    vm.feed('\x03');
    vm.resume(clock.nowUs + 10_000);
    expect([board.display.isAnimating, vm.isInRepl]).toEqual([false, true]);
  });

  it('lets an error scroll by before the REPL greets', () => {
    const { vm, console } = deviceWith('x', { repl: 'at-once' });
    vm.resume(SECOND);
    vm.resume(3 * SECOND);
    expect(console()).not.toContain('>>>');
    vm.resume(60 * SECOND);
    expect(console()).toMatch(/isn't defined\n.*>>> $/s);
  });
});

describe('the line editor', () => {
  const edit = (keys: string): { text: string; sent: string } => {
    let sent = '';
    const editor = new LineEditor((text) => (sent += text));
    editor.begin('>>> ');
    for (const byte of new TextEncoder().encode(keys)) {
      if (editor.key(byte) === 'line') {
        const { text } = editor;
        if (!keys.endsWith('\r')) editor.begin('>>> ');
        else if (text !== '') editor.begin('>>> ');
      }
    }
    return { text: editor.text, sent };
  };

  it('moves with the arrows, Home and End, and inserts there', () => {
    expect(edit('bd\x1b[Dc\x1b[Ha\x1b[Fe').text).toBe('abcde');
    expect(edit('ac\x1b[D\x1b[D\x1b[C\x1bOFd\x1b[D\x1b[Db').text).toBe('abcd');
  });

  it('deletes before and at the cursor', () => {
    expect(edit('abx\x7fc').text).toBe('abc');
    expect(edit('xab\x01\x1b[3~').text).toBe('ab');
  });

  it('recalls the lines typed before', () => {
    expect(edit('one\rtwo\r\x1b[A').text).toBe('two');
    expect(edit('one\rtwo\r\x1b[A\x1b[A').text).toBe('one');
    expect(edit('one\rtwo\r\x1b[A\x1b[A\x1b[B!').text).toBe('two!');
    expect(edit('one\r\x1b[A\x1b[B').text).toBe('');
  });

  it('moves the terminal as the device does: steps of up to 4 by backspaces, longer ones by a sequence', () => {
    expect(edit('abcdef\x1b[H').sent).toBe('>>> abcdef\x1b[6D');
    expect(edit('abc\x1b[D\x1b[Dx').sent).toBe('>>> abc\b\bxbc\b\b');
  });

  it('keeps letters beyond ASCII', () => expect(edit('Zürich').text).toBe('Zürich'));
});

describe('another line', () => {
  it.each(['if x:', 'def f():\n    return', '@decorator', 'f(1,', '[1,\n2', '"""a', "x = '''", 'x = 1 + \\'])(
    'is asked for after %j',
    (input) => expect(wantsMore(input)).toBe(true),
  );

  it.each(['', 'x = 1', 'iffy', 'f(1)', "'('", '"a', 'if x:\n    y\n', 'x = """a"""', "'\\''"])(
    'is not asked for after %j',
    (input) => expect(wantsMore(input)).toBe(false),
  );
});

describe('a dialogue', () => {
  it('knows no Python: it hands over what is to be run', () => {
    const port = new ConsolePort(() => undefined);
    port.interruptByte = null;
    const repl = new Repl(port, 'Banner', true);
    repl.programEnded();
    port.feed('a = 1\r');
    expect(repl.next()).toEqual({ type: 'statement', source: 'a = 1' });
    repl.listen();
    port.feed('a.b.c\t');
    expect(repl.next()).toEqual({ type: 'names', path: 'a.b' });
  });
});
