import { describe, expect, it } from 'vitest';
import { microbitV2 } from '#board/boards/microbit-v2';
import { LATER, linesOf, play } from './testing/play';

describe('display in Python', () => {
  it('shows one picture or character at once', () => {
    const run = play('from microbit import *\ndisplay.show(Image.HEART)\nsleep(10)\ndisplay.show(7)\n').until(5);
    expect(run.bench.picture()).toBe('.9.9.\n99999\n99999\n.999.\n..9..');
    expect(run.until(20).bench.picture()).toBe('99999\n...9.\n..9..\n.9...\n9....');
  });

  it('takes as long as the device on its 6 ms tick', () => {
    const program = `
print(exact(display.show, '12'), exact(display.show, 'abc', 100), exact(display.show, 'abc', 100, clear=True))
print(exact(display.scroll, 'Hi'), exact(display.scroll, 'Hi', delay=60), exact(display.scroll, 7, 60, monospace=True))
print(exact(display.show, Image.ALL_CLOCKS, delay=50))
print(exact(display.scroll, 'Hi', wait=False), exact(display.show, ''), exact(display.show, []))`;
    expect(linesOf(program)).toEqual(['804 306 408', '1800 720 600', '648', '0 0 0']);
  });

  it('shows for exactly 804 ms and scrolls for exactly 720 ms when the call begins on a tick', () => {
    const { bench, until, ended } = play(`
from microbit import *
display.show('12')`);
    const changes: string[] = [];
    let before = bench.picture();
    for (let ms = 1; ms < 2000; ms++) {
      until(ms);
      if (bench.picture() !== before) changes.push(`${ms} ms`);
      before = bench.picture();
      if (ended()) {
        changes.push(`ended by ${ms} ms`);
        break;
      }
    }
    // Begun within the first ms, the ticks come at 6, 12, …: the second picture at 402, the end at 804.
    expect(changes).toEqual(['1 ms', '402 ms', 'ended by 805 ms']);
  });

  it('never ends by a loop, and with clear shows the blank for one more delay', () => {
    const program = `
t = running_time()
display.show('A', 100, clear=True)
print(running_time() - t)
display.show('AB', 100, loop=True, wait=False)
sleep(10000)
print(display.get_pixel(0, 4) + display.get_pixel(1, 0))`;
    expect(linesOf(program)).toEqual(['204', '18']);
  });

  it('clears at once on v2.1.2, and what moves goes on; newer firmwares end it, and wait for the tick', () => {
    const program = `
display.show('xyz', delay=200, loop=True, wait=False)
while running_time() % 6 != 1:
    pass
t = running_time()
display.clear()
print(running_time() - t, any(display.get_pixel(x, y) for x in range(5) for y in range(5)))
sleep(900)
print(any(display.get_pixel(x, y) for x in range(5) for y in range(5)))`;
    expect(linesOf(program)).toEqual(['0 False', 'True']);
    for (const device of LATER) expect(linesOf(program, {}, undefined, device)).toEqual(['5 False', 'False']);
  });

  it('counts bytes, as the device does: an umlaut is two unknown characters, and no single one in a list', () => {
    const program = `
print(exact(display.show, 'ä'), exact(display.show, 'Tür', 100), exact(display.show, ['ä', 'b']), exact(display.show, ['a', '€', 'b'], 90))
display.show('é')
print(''.join(str(display.get_pixel(x, 0)) for x in range(5)))`;
    expect(linesOf(program)).toEqual(['804 408 0 90', '09990']);
  });

  it('ends a sequence without an error at a text of two letters, as the device does', () => {
    expect(
      linesOf("print(took(display.show, ['A', 'BC', 'D'], 100) < 103)\nprint(took(display.show, ['AB']))"),
    ).toEqual(['True', '0']);
  });

  it('shows the pictures before a mistake, then raises', () => {
    const program = `
t = running_time()
err(display.show, [Image.HEART, 5, Image.SAD], 100)
print(90 < running_time() - t < 110, display.get_pixel(1, 0))`;
    expect(linesOf(program)).toEqual(['TypeError: not an image', 'True 9']);
  });

  it('rotates on firmwares that can: 90 degrees and what is nearest', () => {
    const program = `
display.set_pixel(0, 0, 9)
display.rotate(100)`;
    const device = { firmware: microbitV2.firmwares[1] };
    expect(play(`from microbit import *${program}`, {}, undefined, device).until(10).bench.picture()).toBe(
      '.....\n.....\n.....\n.....\n9....',
    );
    expect(linesOf('err(lambda: display.rotate(90))')).toEqual([
      "AttributeError: 'MicroBitDisplay' object has no attribute 'rotate'",
    ]);
  });

  it('goes on in the background with wait=False, and the next show replaces it', () => {
    const run = play(`
from microbit import *
display.show('AB', delay=60, wait=False, loop=True)
sleep(1000)
display.show(Image.HEART)
sleep(1000)`);
    const pictures = new Set<string>();
    for (let ms = 10; ms < 900; ms += 10) pictures.add(run.until(ms).bench.picture());
    expect(pictures.size).toBe(2);
    expect(run.until(1500).bench.picture()).toBe('.9.9.\n99999\n99999\n.999.\n..9..');
  });

  it('reads a picture in the background when it is due, and not before', () => {
    const program = `
dot = Image(5, 5)
pictures = [dot, dot]
display.show(pictures, delay=50, loop=True, wait=False)
sleep(120)
dot.set_pixel(2, 2, 9)
pictures.clear()
del dot
import gc
gc.collect()
junk = [Image(5, 5) for _ in range(50)]
sleep(120)
print(display.get_pixel(2, 2))`;
    expect(linesOf(program)).toEqual(['9']);
  });

  it('asks a generator for its pictures one by one', () => {
    const run = play(`
from microbit import *
def forever():
    while True:
        yield 'x'
        yield Image.HEART
display.show(forever(), 100)`);
    expect(run.until(3050).ended()).toBeNull();
    expect(run.bench.board.display.pixels.some((led) => led > 0)).toBe(true);
  });

  it('asks it in the background too: 34 pictures of 30 ms in a second, whatever the program does meanwhile', () => {
    const run = play(`
from microbit import *
asked = 0
def forever():
    global asked
    while True:
        asked += 1
        yield str(asked % 10)
display.show(forever(), 30, wait=False)
while running_time() < 1000:
    pass
print(asked)
display.show(Image.HEART)
sleep(1000)
print(asked)`);
    run.until(2500);
    expect(run.printed()).toBe('34\n34\n');
  });

  it('shows the blank picture of clear for one more delay after a generator too', () => {
    const program = `
print(exact(display.show, iter('ab'), 60), exact(display.show, iter('ab'), 60, clear=True))
display.show((c for c in 'ab'), 60, clear=True, wait=False)
sleep(100)
print(sum(display.get_pixel(x, y) for x in range(5) for y in range(5)) > 0)
sleep(100)
print(sum(display.get_pixel(x, y) for x in range(5) for y in range(5)))`;
    expect(linesOf(program)).toEqual(['120 180', 'True', '0']);
  });

  it('ends a generator when a callback shows something else, which runs when the next picture is asked for; tells of its mistakes', () => {
    const program = `
def pictures():
    for letter in 'abcdef':
        yield letter
run_every(lambda: display.show(Image.HEART), ms=300)
t = running_time()
display.show(pictures(), 200)
print(running_time() - t < 410)
def wrong():
    yield 'a'
    yield 7
try:
    display.show(wrong(), 60, wait=False)
    sleep(200)
except BaseException as error:
    print(repr(error))
err(display.show, pictures(), loop=True)`;
    expect(linesOf(program)).toEqual([
      'True',
      "TypeError('not an image',)",
      "TypeError: object of type 'generator' has no len()",
    ]);
  });

  it('lets a program put nothing into the objects of the device', () => {
    const program = `
def put(thing):
    thing.text = 'Hi'
for thing in (display, pin0, pin5, pin_logo, button_a, i2c, uart, spi, accelerometer, compass, microphone, speaker):
    err(put, thing)`;
    const lines = linesOf(program);
    expect(lines).toHaveLength(12);
    expect(lines[0]).toBe("AttributeError: 'MicroBitDisplay' object has no attribute 'text'");
    for (const line of lines) expect(line).toMatch(/^AttributeError: 'MicroBit\w+' object has no attribute 'text'$/);
  });

  it('sets and gets pixels, and clear has worked when it returns', () => {
    const program = `
display.set_pixel(2, 3, 7)
print(display.get_pixel(2, 3))
display.clear()
display.set_pixel(0, 0, 9)
sleep(20)
print(display.get_pixel(2, 3), display.get_pixel(0, 0))
print(display.is_on(), display.read_light_level())
display.off()
print(display.is_on(), pin3.read_digital())
display.on()
err(pin3.read_digital)`;
    expect(linesOf(program)).toEqual(['7', '0 9', 'True 127', 'False 0', 'ValueError: Pin 3 in display mode']);
  });

  it('refuses mistakes in the words of the device', () => {
    const program = `
err(display.get_pixel, 5, 0)
err(display.set_pixel, 0, 5, 1)
err(display.set_pixel, 0, 0, 10)
err(display.set_pixel, 0.5, 0, 1)
err(display.set_pixel, 2**32, 0, 1)
err(display.get_pixel, 0, -2**40)
err(display.show, [1])
err(display.show, None)
err(display.scroll, None)
err(display.show, 'ab', 'x')`;
    expect(linesOf(program)).toEqual([
      'ValueError: index out of bounds',
      'ValueError: index out of bounds',
      'ValueError: brightness out of bounds',
      "TypeError: can't convert float to int",
      'OverflowError: overflow converting long int to machine word',
      'OverflowError: overflow converting long int to machine word',
      'TypeError: not an image',
      "TypeError: 'NoneType' object isn't iterable",
      "TypeError: can't convert 'NoneType' object to str implicitly",
      "TypeError: can't convert str to int",
    ]);
  });
});
