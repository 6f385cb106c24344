import { describe, expect, it } from 'vitest';
import { microbitV2 } from '../boards/microbit-v2';
import { createBench } from '../testing/bench';

const newest = microbitV2.firmwares.find(({ id }) => id === 'newest')!;

describe('microphone', () => {
  it('H1: begins to listen, and lights its light, when it is first used', () => {
    const { board } = createBench();
    board.sensors.set('soundLevel', 200);
    board.sensors.set('soundLevel', 0);
    expect(board.microphone.isListening).toBe(false);
    board.microphone.listen();
    expect([board.microphone.isListening, board.microphone.currentEvent, board.microphone.takeEvents()]).toEqual([
      true,
      'quiet',
      [],
    ]);
    board.reset();
    expect(board.microphone.isListening).toBe(false);
  });

  it('H1: hears at once that it is loud when it begins to listen in a noise', () => {
    const { board } = createBench();
    board.sensors.set('soundLevel', 200);
    board.microphone.listen();
    expect(board.microphone.currentEvent).toBe('loud');
  });

  it('H2: is loud from 150 on and quiet from 75 down, one after the other', () => {
    const { board } = createBench();
    board.microphone.listen();
    for (const level of [149, 150, 140, 160, 76, 75, 0, 151]) board.sensors.set('soundLevel', level);
    expect(board.microphone.takeEvents()).toEqual(['loud', 'quiet', 'loud']);
  });

  it('H3: a threshold comes within 0 … 255, takes the other one along, and counts at once', () => {
    const { microphone, sensors } = createBench().board;
    microphone.listen();
    microphone.setThreshold('loud', 50);
    expect(microphone.threshold).toEqual({ quiet: 49, loud: 50 });
    microphone.setThreshold('quiet', 300);
    expect(microphone.threshold).toEqual({ quiet: 255, loud: 255 });
    sensors.set('soundLevel', 100);
    microphone.setThreshold('loud', 90);
    expect([microphone.currentEvent, microphone.threshold]).toEqual(['loud', { quiet: 89, loud: 90 }]);
  });

  it('H4: wasEvent forgets its own event and the list; the list keeps the first 8', () => {
    const { microphone, sensors } = createBench().board;
    microphone.listen();
    for (let i = 0; i < 5; i++) for (const level of [200, 0]) sensors.set('soundLevel', level);
    expect(microphone.takeEvents()).toEqual(Array.from({ length: 4 }, () => ['loud', 'quiet']).flat());
    expect([microphone.wasEvent('loud'), microphone.wasEvent('loud'), microphone.wasEvent('quiet')]).toEqual([
      true,
      false,
      true,
    ]);
  });

  it('H5: 0 is 52 dB and 255 is 100 dB', () => {
    const { microphone, sensors } = createBench().board;
    expect(microphone.soundLevelDb).toBe(52);
    sensors.set('soundLevel', 255);
    expect([microphone.soundLevel, microphone.soundLevelDb]).toEqual([255, 100]);
  });

  it.each([
    [22, []],
    [23, ['clap']],
    [151, ['clap']],
    [152, []],
  ])('H6: a noise of %i ms after 232 ms of silence is %j to the newest firmware', (ms, heard) => {
    const { board, passMs } = createBench(microbitV2, newest);
    board.microphone.listen();
    passMs(232);
    board.sensors.set('soundLevel', 255);
    passMs(ms);
    board.sensors.set('soundLevel', 10);
    expect(board.microphone.takeEvents().filter((kind) => kind === 'clap')).toEqual(heard);
  });

  it('H6: v2.1.2 knows no clap, and a second one too soon is none', () => {
    for (const [firmware, claps] of [[undefined, 0] as const, [newest, 1] as const]) {
      const { board, passMs } = createBench(microbitV2, firmware);
      board.microphone.listen();
      passMs(500);
      for (let i = 0; i < 2; i++) {
        board.sensors.set('soundLevel', 255);
        passMs(50);
        board.sensors.set('soundLevel', 0);
        passMs(100);
      }
      expect(board.microphone.takeEvents().filter((kind) => kind === 'clap')).toHaveLength(claps);
    }
  });

  it('H7: records a tone as loud as it is at the time, sample for sample', () => {
    const { board, passMs } = createBench();
    const samples = new Uint8Array(1000);
    board.microphone.record({ rateHz: 10_000, length: 1000, write: (at, part) => samples.set(part, at) });
    expect(board.microphone.isListening).toBe(true);
    passMs(25);
    board.sensors.set('soundLevel', 255);
    passMs(50);
    board.sensors.set('soundLevel', 128);
    passMs(24.9);
    expect(board.microphone.isRecording).toBe(true);
    passMs(0.1);
    expect(board.microphone.isRecording).toBe(false);
    const peak = (from: number, to: number): number => Math.max(...samples.subarray(from, to)) - 128;
    expect([peak(0, 250), peak(250, 750), peak(750, 1000)]).toEqual([0, 127, 64]);
    expect(Math.min(...samples)).toBe(1);
  });

  it('H7: a recording that is stopped keeps what it has; sensitivity makes it louder', () => {
    const { board, passMs } = createBench();
    const samples: number[] = [];
    board.sensors.set('soundLevel', 51);
    board.microphone.setSensitivity(0.4);
    board.microphone.record({ rateHz: 7812, length: 5000, write: (_, part) => samples.push(...part) });
    passMs(100);
    board.microphone.stopRecording();
    passMs(100);
    expect([samples.length, Math.max(...samples) - 128]).toEqual([781, 51]);
  });
});
