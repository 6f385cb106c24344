import { describe, expect, it } from 'vitest';
import { Board } from '#board/board';
import { microbitV2 } from '#board/boards/microbit-v2';
import type { EffectPart } from '#board/sound/effect';
import { Clock } from '#core/clock';
import { Hearing, levelAt } from './hearing';

/** A board that plays a tone of a volume, so far from the microphone at (0 | 0). */
function speaker(farMm: number, volume = 255) {
  const board = new Board(microbitV2, new Clock());
  board.sound.setVolume(volume);
  board.sound.playEffect([TONE]);
  return { board, at: { x: 0, y: -farMm } };
}
const TONE: EffectPart = {
  ...{ waveform: 0, startVolume: 1023, endVolume: 1023, startHz: 440, endHz: 440, durationMs: 1000 },
  ...{ shape: 0, steps: 0, fx: 0, fxParameter: 0, fxSteps: 0 },
};
const here = { x: 0, y: 0 };
const heard = (...speakers: ReturnType<typeof speaker>[]): number => levelAt(here, speakers);

describe('what a microphone hears of other boards', () => {
  it('is as loud as their volume up to 30 cm, half of it at 60 cm, and nothing beyond 2 m', () => {
    expect([heard(speaker(50)), heard(speaker(300)), heard(speaker(600)), heard(speaker(1000))]).toEqual([
      ...[255, 255, 128, 77],
    ]);
    expect(heard(speaker(2001))).toBe(0);
    expect(heard(speaker(300, 128))).toBe(128);
  });

  it('is the loudest of them, and nothing of who is silent or has its speaker off', () => {
    const [silent, off] = [speaker(100), speaker(100)];
    silent.board.sound.silence('effect');
    off.board.sound.setSpeaker(false);
    expect(heard(silent, off)).toBe(0);
    expect(heard(silent, off, speaker(600), speaker(1000))).toBe(128);
    expect(heard()).toBe(0);
  });
});

describe('a microphone', () => {
  it('hears the louder of the others and of what is set by hand, only while it is switched on', () => {
    const { sensors } = new Board(microbitV2, new Clock());
    let others = 100;
    const hearing = new Hearing(sensors, () => others);
    const level = (): number => {
      hearing.step();
      return sensors.get('soundLevel');
    };
    expect(level()).toBe(0);
    hearing.switch(true);
    expect(level()).toBe(100);
    sensors.set('soundLevel', 180);
    expect(level()).toBe(180);
    others = 200;
    expect(level()).toBe(200);
    others = 0;
    expect(level()).toBe(180);
    others = 200;
    hearing.step();
    hearing.switch(false);
    expect(level()).toBe(180);
  });
});
