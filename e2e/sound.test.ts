import { createBench, type Bench } from '../src/board/testing/bench';
import { readEffect } from '../src/board/sound/effect';
import { BUILT_IN_SOUNDS } from '../src/board/sound/built-in-sounds';
import { phonemesOf } from '../src/board/sound/letter-rules';
import type { SoundEvent } from '../src/board/sound/sound-event';
import { utter } from '../src/board/sound/utter';
import { createRng } from '../src/core/rng';
import { expect, test } from './app';

const PROBE = process.env['PARCOURS_PROBE'] ?? '';

/** The events of a board's sound hardware while it is used for a time. */
function soundOf(use: (bench: Bench) => void, forMs: number): readonly SoundEvent[] {
  const events: SoundEvent[] = [];
  const bench = createBench();
  bench.board.sound.onEvent((event) => events.push(event));
  use(bench);
  bench.passMs(forMs);
  return events;
}

/** From when to when it was loud, in ms; pauses of less than 5 ms do not count. */
function stretchesOf(loudness: readonly number[]): readonly (readonly [number, number])[] {
  const stretches: [number, number][] = [];
  loudness.forEach((value, ms) => {
    if (value < 80) return; // a fifth of a tone
    const last = stretches.at(-1);
    if (last !== undefined && ms - last[1] < 5) last[1] = ms + 1;
    else stretches.push([ms, ms + 1]);
  });
  return stretches;
}

test('a melody sounds at the ms and with the pitch of its notes', async ({ app }) => {
  const events = soundOf(
    ({ board }) => board.music.play(['c4:2', 'a:2', 'r:1', 'a5:1'], { pin: null, loop: false }),
    900,
  );
  const stretches = [
    { fromMs: 20, toMs: 230 },
    { fromMs: 280, toMs: 490 },
    { fromMs: 660, toMs: 750 },
  ];
  await app.goto(PROBE);
  const heard = await app.evaluate(({ all, at }) => window.hear(all, 900, at), { all: events, at: stretches });
  const found = stretchesOf(heard.loudness);
  const expected = [
    [6, 246],
    [258, 498],
    [642, 762],
  ] as const;
  expect(found).toHaveLength(expected.length);
  expected.forEach(([from, to], note) => {
    expect(Math.abs((found[note]?.[0] ?? 0) - from)).toBeLessThanOrEqual(1);
    expect(Math.abs((found[note]?.[1] ?? 0) - to)).toBeLessThanOrEqual(3);
  });
  [262, 440, 880].forEach((hz, note) => {
    expect(Math.abs((heard.peaksHz[note] ?? 0) - hz)).toBeLessThanOrEqual(2);
  });
});

test('an effect glides from its first to its last frequency', async ({ app }) => {
  // A square wave from 500 to 2500 Hz in 500 ms, linear, in 128 steps, loud to the end.
  const text = [
    '3',
    '1023',
    '0500',
    '0500',
    '01',
    '000',
    '2500',
    '0000',
    '1023',
    '0128',
    '00',
    '0001',
    '0024',
    '0'.repeat(28),
  ].join('');
  const events = soundOf(({ board }) => board.sound.playEffect(readEffect(text, createRng(1)) ?? []), 600);
  await app.goto(PROBE);
  const at = [
    { fromMs: 0, toMs: 20 },
    { fromMs: 240, toMs: 260 },
    { fromMs: 475, toMs: 495 },
  ];
  const heard = await app.evaluate(({ all, parts }) => window.hear(all, 600, parts), { all: events, parts: at });
  expect(stretchesOf(heard.loudness)).toEqual([[0, 500]]);
  const [begin = 0, middle = 0, end = 0] = heard.peaksHz;
  expect(Math.abs(begin - 540)).toBeLessThan(60);
  expect(Math.abs(middle - 1500)).toBeLessThan(80);
  expect(Math.abs(end - 2440)).toBeLessThan(80);
});

test('a built-in sound lasts as long as its parts', async ({ app }) => {
  const events = soundOf(
    ({ board }) => board.sound.playEffect(readEffect(BUILT_IN_SOUNDS['hello'] ?? '', createRng(1)) ?? []),
    600,
  );
  await app.goto(PROBE);
  const heard = await app.evaluate((all) => window.hear(all, 600, []), events);
  expect(stretchesOf(heard.loudness).map(([from, to]) => [from, Math.round(to)])).toEqual([
    [0, 197],
    [213, 506],
  ]);
});

test('samples of a program follow one another without a gap', async ({ app }) => {
  const wave = Array.from({ length: 32 }, (_, i) => (i % 16 < 8 ? 200 : 56));
  const events = soundOf(({ board }) => {
    let left = 20;
    const { stream } = board.sound;
    const next = (): void => (left-- > 0 ? stream.write({ samples: wave, rate: 7812 }) : stream.close());
    stream.open(next);
    next();
  }, 200);
  await app.goto(PROBE);
  const heard = await app.evaluate((all) => window.hear(all, 200, [{ fromMs: 10, toMs: 70 }]), events);
  expect(stretchesOf(heard.loudness)).toEqual([[0, 82]]);
  expect(Math.abs((heard.peaksHz[0] ?? 0) - 7812 / 16)).toBeLessThanOrEqual(2);
});

test('speech is as long as the program waits, and about as loud as a tone', async ({ app }) => {
  const voice = { pitch: 64, speed: 72, mouth: 128, throat: 128, sings: false };
  const utterance = utter(phonemesOf('hello world') ?? '', voice);
  if (utterance === null) throw new Error('"hello world" has no phonemes.');
  const events = soundOf(({ board }) => board.sound.speak(utterance), 1000);
  await app.goto(PROBE);
  const heard = await app.evaluate((all) => window.hear(all, 1000, []), events);
  const loud = stretchesOf(heard.loudness);
  expect(loud.at(-1)?.[1]).toBeLessThanOrEqual(888);
  expect(Math.max(...heard.loudness)).toBeGreaterThan(110);
  expect(heard.peak, 'near −6 dB').toBeGreaterThan(0.4);
  expect(heard.peak).toBeLessThan(0.7);
});

test('the volume, the speaker and a stop are heard at once', async ({ app }) => {
  const events = soundOf(({ board, passMs }) => {
    board.music.pitch(440, -1, null);
    passMs(100);
    board.sound.setVolume(64);
    passMs(100);
    board.sound.setSpeaker(false);
    passMs(100);
    board.sound.setSpeaker(true);
    passMs(100);
    board.music.stop();
  }, 100);
  await app.goto(PROBE);
  const { loudness } = await app.evaluate((all) => window.hear(all, 500, []), events);
  const mean = (from: number): number => loudness.slice(from, from + 50).reduce((sum, value) => sum + value, 0) / 50;
  expect(mean(40), 'its peaks are at −8 dB').toBeGreaterThan(300);
  expect(mean(40)).toBeLessThan(420);
  expect(mean(140) / mean(40)).toBeCloseTo(64 / 255, 1);
  expect(mean(240)).toBeLessThan(1);
  expect(mean(340) / mean(140)).toBeCloseTo(1, 1);
  expect(mean(440)).toBeLessThan(1);
});

test('a tone, an effect and speech at once are loud, and not clipped', async ({ app }) => {
  const voice = { pitch: 64, speed: 72, mouth: 128, throat: 128, sings: false };
  const utterance = utter(phonemesOf('hello world') ?? '', voice);
  if (utterance === null) throw new Error('"hello world" has no phonemes.');
  const events = soundOf(({ board }) => {
    board.music.pitch(440, -1, null);
    board.sound.playEffect(readEffect(BUILT_IN_SOUNDS['hello'] ?? '', createRng(1)) ?? []);
    board.sound.speak(utterance);
  }, 1000);
  await app.goto(PROBE);
  const { peak } = await app.evaluate((all) => window.hear(all, 1000, []), events);
  expect(peak).toBeGreaterThan(0.7);
  expect(peak).toBeLessThan(1);
});
