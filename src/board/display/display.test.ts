import { describe, expect, it } from 'vitest';
import { scrollFilm } from './scroll-text';
import { createBench } from '../testing/bench';

const A = '.99..\n9..9.\n9999.\n9..9.\n9..9.';
const B = '999..\n9..9.\n999..\n9..9.\n999..';
const BLANK = '.....\n.....\n.....\n.....\n.....';
const once = { delayMs: 400, loop: false, clear: false };
const scrolled = { delayMs: 150, loop: false, monospace: false };

/** A board and the pictures of some letters. */
function bench(letters = '') {
  const table = createBench();
  const { display } = table.board;
  return { ...table, display, frames: letters.split('').map((letter) => display.glyph(letter)) };
}

describe('the display', () => {
  it('D1: pictures of 400 ms follow each other after 402 ms, those of 150 ms after 150 ms', () => {
    const { display, frames, picture, waitUntil } = bench('AB');
    display.showFrames(frames, once);
    expect(waitUntil(() => picture() === B)).toBe(402);
    display.showFrames(frames, { ...once, delayMs: 150 });
    expect(waitUntil(() => picture() === B)).toBe(402 + 150);
  });

  it('D1: a delay of 0 takes one tick for each picture', () => {
    const { display, frames, waitUntil } = bench('AB');
    display.showFrames(frames, { ...once, delayMs: 0 });
    expect(waitUntil(() => !display.isAnimating)).toBe(12);
  });

  it('D1: what starts between two ticks gains on the first picture', () => {
    const { display, frames, picture, passUs, waitUntil } = bench('AB');
    passUs(5000);
    display.showFrames(frames, once);
    expect(waitUntil(() => picture() === B)).toBe(402);
  });

  it('D15: who asked is told in the tick of the end, and hears nothing when something else came', () => {
    const { display, frames, clock, passUs } = bench('AB');
    const told: number[] = [];
    const onOver = (): unknown => told.push(clock.nowUs);
    display.showFrames(frames, { ...once, onOver });
    passUs(1_000_000);
    expect(told).toEqual([804_000]);
    display.showFrames(frames, { ...once, onOver });
    passUs(100_000);
    display.show(frames[0] ?? new Uint8Array(25));
    passUs(2_000_000);
    expect(told).toEqual([804_000]);
  });

  it('D2: the first picture is there at once, the last one stays for its delay and then for good', () => {
    const { display, frames, picture, passMs, waitUntil } = bench('AB');
    display.showFrames(frames, once);
    expect(picture()).toBe(A);
    expect(waitUntil(() => !display.isAnimating)).toBe(804);
    passMs(5000);
    expect(picture()).toBe(B);
  });

  it('D2: no pictures take no time, and one picture by itself is simply there', () => {
    const { display, frames, picture } = bench('A');
    display.showFrames([], once);
    expect(display.isAnimating).toBe(false);
    display.show(frames[0]!);
    expect(picture()).toBe(A);
    expect(display.isAnimating).toBe(false);
  });

  it('D2: a picture that is changed afterwards is shown as it was', () => {
    const { display, frames, picture, waitUntil } = bench('AB');
    display.showFrames(frames, once);
    frames[1]!.fill(0);
    waitUntil(() => !display.isAnimating);
    expect(picture()).toBe(B);
  });

  it('D3: with clear the display is blank after the last picture, for one more delay', () => {
    const { display, frames, picture, waitUntil } = bench('AB');
    display.showFrames(frames, { ...once, clear: true });
    expect(waitUntil(() => picture() === BLANK)).toBe(804);
    expect(waitUntil(() => !display.isAnimating)).toBe(1206);
  });

  it('D4: with loop it begins again and never ends', () => {
    const { display, frames, picture, passMs, waitUntil } = bench('AB');
    display.showFrames(frames, { ...once, loop: true });
    waitUntil(() => picture() === B);
    expect(waitUntil(() => picture() === A)).toBe(804);
    passMs(60_000);
    expect(display.isAnimating).toBe(true);
  });

  it('D4: a scrolling text with loop comes in again after its blank columns', () => {
    const { display, picture, passMs } = bench();
    display.scroll('A', { ...scrolled, loop: true });
    const first = picture();
    passMs(9 * 150);
    expect(picture()).toBe(first);
    expect(display.isAnimating).toBe(true);
  });

  it('D5: a new show ends the one before', () => {
    const { display, frames, picture, passMs } = bench('ABA');
    display.showFrames(frames, { ...once, loop: true });
    display.showFrames([frames[1]!], once);
    passMs(600);
    expect(picture()).toBe(B);
    display.showFrames(frames, { ...once, loop: true });
    display.show(frames[0]!);
    passMs(600);
    expect(picture()).toBe(A);
    expect(display.isAnimating).toBe(false);
  });

  it('D6: clear blanks the display at the next tick and is over then', () => {
    const { display, frames, picture, passMs, passUs, waitUntil } = bench('AB');
    display.showFrames(frames, { ...once, loop: true });
    passMs(13);
    display.clear();
    expect(picture()).toBe(A);
    expect(display.isAnimating).toBe(true);
    expect(waitUntil(() => !display.isAnimating)).toBe(18);
    expect(picture()).toBe(BLANK);
    passUs(1_000_000);
    expect(picture()).toBe(BLANK);
  });

  it('D7: a pixel set during an animation stays until the next picture', () => {
    const { display, frames, passMs } = bench('AB');
    display.showFrames(frames, once);
    display.setPixel(4, 4, 7);
    expect(display.getPixel(4, 4)).toBe(7);
    passMs(402);
    expect(display.getPixel(4, 4)).toBe(0);
  });

  it('D8: letters scroll as wide as they are, with one blank column between them', () => {
    expect(bottomRow('AB', false)).toBe('9..9.999..' + '....');
    expect(bottomRow('AB', true)).toBe('9..9..999..' + '.....');
  });

  it('D8: a blank first column is left out, but not that of the first letter; three columns at least', () => {
    expect(columnCount('!')).toBe(3 + 5);
    expect(columnCount('A!')).toBe(4 + 1 + 2 + 5);
    expect(columnCount(' ')).toBe(3 + 5);
  });

  it('D9: "A" has left after nine columns, 1350 ms; nothing at all after five', () => {
    const { display, picture, waitUntil } = bench();
    display.scroll('A', scrolled);
    expect(picture()).toBe('.....\n....9\n....9\n....9\n....9');
    expect(waitUntil(() => !display.isAnimating)).toBe(1350);
    expect(picture()).toBe(BLANK);
    display.scroll('', scrolled);
    expect(waitUntil(() => !display.isAnimating)).toBe(1350 + 750);
  });

  it('D10: a character without a picture shows as ?, an umlaut as two of them', () => {
    const { display } = bench();
    expect(display.glyph('ä')).toEqual(display.glyph('?'));
    expect(display.glyph('constructor')).toEqual(display.glyph('?'));
    expect(scrollFrames('ä', false)).toEqual(scrollFrames('??', false));
    expect(scrollFrames('🙂', true)).toEqual(scrollFrames('????', true));
  });

  it('D11: off is dark and gives pin 3 to the program, on brings the picture back', () => {
    const { board, display, frames, picture } = bench('A');
    display.show(frames[0]!);
    display.off();
    expect(picture()).toBe(BLANK);
    expect(display.getPixel(1, 0)).toBe(9);
    board.pin('pin3').writeDigital(1);
    expect(board.wire('P3').level).toBe(1);
    expect(display.on()).toBeNull();
    expect(display.isOn).toBe(true);
    expect(picture()).toBe(A);
    expect(board.pin('pin3').acquire('write_digital')).toBe('display');
  });

  it('D11: on is refused while music has one of its pins', () => {
    const { board, display } = bench();
    display.off();
    board.music.pitch(440, -1, board.pin('pin3'));
    expect(display.on()).toBe('Pin 3 in music mode');
    expect(display.isOn).toBe(false);
  });

  it('D12: LEDs and brightnesses that do not exist have the words of the device', () => {
    const { display } = bench();
    expect(() => display.setPixel(5, 0, 9)).toThrow('index out of bounds');
    expect(() => display.getPixel(0, -1)).toThrow('index out of bounds');
    expect(() => display.setPixel(0, 0, 10)).toThrow('brightness out of bounds');
  });

  it('D13: a negative delay never ends', () => {
    const { display, frames, picture, passMs } = bench('AB');
    display.showFrames(frames, { ...once, delayMs: -1 });
    passMs(3_600_000);
    expect(picture()).toBe(A);
    expect(display.isAnimating).toBe(true);
  });

  it('D14: rotated by a quarter turn the top row shows in the left column; LEDs keep their numbers', () => {
    const { display, picture } = bench();
    for (let x = 0; x < 5; x++) display.setPixel(x, 0, x + 1);
    display.rotate(1);
    expect(picture()).toBe('5....\n4....\n3....\n2....\n1....');
    display.rotate(2);
    expect(picture()).toBe('.....\n.....\n.....\n.....\n54321');
    display.rotate(3);
    expect(picture()).toBe('....1\n....2\n....3\n....4\n....5');
    expect(display.getPixel(4, 0)).toBe(5);
    display.rotate(4);
    expect(picture()).toBe('12345\n.....\n.....\n.....\n.....');
  });
});

/** All pictures of a scrolling text. */
function scrollFrames(text: string, monospace: boolean): Uint8Array[] {
  const film = scrollFilm(text, monospace);
  return Array.from({ length: film.length }, (_, place) => film.frameAt(place));
}

/** The bottom row of a text as it passes the right-hand edge. */
function bottomRow(text: string, monospace: boolean): string {
  return scrollFrames(text, monospace)
    .map((frame) => (frame[24] === 0 ? '.' : '9'))
    .join('');
}

function columnCount(text: string): number {
  return scrollFrames(text, false).length;
}
