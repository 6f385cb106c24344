import { describe, expect, it } from 'vitest';
import { createBench } from './testing/bench';

describe('order in time', () => {
  it('T1: two alarms for the same microsecond ring in the order in which they were set', () => {
    const { board, chip, clock, record, passMs } = createBench();
    const end = chip('P8');
    const happened = record('P8');
    clock.at(1000, () => end.drive(1));
    clock.at(1000, () => end.drive(0));
    passMs(2);
    expect(happened).toEqual(['1 ms: 1', '1 ms: 0']);
    expect(board.wire('P8').level).toBe(0);
  });

  it('T2: ticks come at multiples of 6 ms however late somebody needs the first', () => {
    const { board, passUs, waitUntil } = createBench();
    passUs(123_457);
    board.display.clear();
    expect(waitUntil(() => !board.display.isAnimating)).toBe(126);
  });

  it('T3: what happens exactly at a tick waits for the next one', () => {
    const { board, passMs, waitUntil } = createBench();
    passMs(6);
    board.display.clear();
    expect(waitUntil(() => !board.display.isAnimating)).toBe(12);
  });

  it('T3: a button pressed in the microsecond of a sample is seen one sample later', () => {
    const { board, passMs, waitUntil } = createBench();
    passMs(4);
    board.buttonA.press();
    expect(waitUntil(() => board.buttonA.isPressed())).toBe(40);
  });

  it('T4: within a tick the display changes before the music, also when the music started first', () => {
    const { board, record, picture, passMs } = createBench();
    const seen: string[] = [];
    board.music.play(['a'], { pin: board.pin('pin0'), loop: false });
    board.display.showFrames([board.display.glyph('A'), new Uint8Array(25)], { delayMs: 6, loop: false, clear: false });
    board.wire('P0').onPwm(() => seen.push(picture()));
    const happened = record('P0');
    passMs(6);
    expect(happened).toHaveLength(1);
    expect(seen).toEqual(['.....\n.....\n.....\n.....\n.....']);
  });

  it('T5: a chip has answered before the call that asked it returns', () => {
    const { board, chip } = createBench();
    const answer = chip('P2');
    board.wire('P1').onLevel((level) => answer.drive(level));
    board.pin('pin1').writeDigital(1);
    expect(board.pin('pin2').readDigital()).toBe(1);
  });

  it('T5: the same calls at the same times give the same record', () => {
    expect(aBusySecond()).toEqual(aBusySecond());
  });
});

function aBusySecond(): readonly string[] {
  const { board, record, passUs } = createBench();
  const happened = record('P0');
  board.music.play(['c', 'e:1', 'g'], { pin: board.pin('pin0'), loop: true });
  for (let step = 0; step < 100; step++) {
    passUs(10_007);
    if (step % 7 === 0) board.buttonA.press();
    if (step % 7 === 5) board.buttonA.release();
    if (board.buttonA.wasPressed()) board.music.setTempo({ bpm: 100 + step });
  }
  return happened;
}
