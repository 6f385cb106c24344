import type { SoundOutput } from '../../session/run/sound/sound-player';
import type { Tones } from './tones';

/** Loudness, 0 … 1. Chosen: the program's own tones have 0.4 and stay in front. */
const BEAT_GAIN = 0.1;
const LINE_GAIN = 0.04;
/** Length of a beep, and how long a tone takes to begin, to end and to change, in s. */
const BEEP_S = 0.06;
const EDGE_S = 0.015;

/**
 * Interval at which the sound system is requested, in ms: it sleeps some seconds after the last request, and may be
 * refused.
 */
const ASK_MS = 500;

/** Plays tones into the page's sound system. */
export interface TonePlayer {
  /** Plays the tones for now, by the wall clock. Call it some twenty times a second: beeps begin with it. */
  play(tones: Tones, nowMs: number): void;
  stop(): void;
}

/** @param output the page's sound system, or `null` while nothing is to be heard */
export function createTonePlayer(output: () => SoundOutput | null): TonePlayer {
  let lastBeepS = -Infinity;
  let line: LineVoice | null = null;
  let out: SoundOutput | null = null;
  let askedMs = -Infinity;

  function endLine(): void {
    line?.end();
    line = null;
  }
  /** Plays the tones; silence does not wake the sound system. */
  function play({ beat, line: tone }: Tones, nowMs: number): void {
    if (tone === null) endLine();
    if (beat === null && tone === null) return;
    if (nowMs - askedMs >= ASK_MS) [out, askedMs] = [output(), nowMs];
    if (out === null) {
      endLine();
      return;
    }
    const nowS = out.context.currentTime;
    if (beat !== null && nowS - lastBeepS >= beat.everyMs / 1000) {
      lastBeepS = nowS;
      beep(out, beat.hz);
    }
    if (tone !== null) (line ??= createLineVoice(out, tone.hz)).set(tone);
  }
  return {
    play,
    stop: endLine,
  };
}

function beep({ context, to }: SoundOutput, hz: number): void {
  const oscillator = context.createOscillator();
  const gain = context.createGain();
  const nowS = context.currentTime;
  oscillator.frequency.value = hz;
  gain.gain.value = 0;
  gain.gain.setTargetAtTime(BEAT_GAIN, nowS, EDGE_S / 3);
  gain.gain.setTargetAtTime(0, nowS + BEEP_S, EDGE_S / 3);
  oscillator.connect(gain).connect(to);
  oscillator.start(nowS);
  oscillator.stop(nowS + BEEP_S + 3 * EDGE_S);
}

interface LineVoice {
  set(tone: NonNullable<Tones['line']>): void;
  end(): void;
}

function createLineVoice({ context, to }: SoundOutput, hz: number): LineVoice {
  const oscillator = context.createOscillator();
  const gain = context.createGain();
  const panner = context.createStereoPanner();
  oscillator.type = 'triangle';
  oscillator.frequency.value = hz;
  gain.gain.value = 0;
  gain.gain.setTargetAtTime(LINE_GAIN, context.currentTime, EDGE_S);
  oscillator.connect(gain).connect(panner).connect(to);
  oscillator.start();
  return {
    set(tone) {
      oscillator.frequency.setTargetAtTime(tone.hz, context.currentTime, EDGE_S);
      panner.pan.setTargetAtTime(tone.pan, context.currentTime, EDGE_S);
    },
    end() {
      gain.gain.setTargetAtTime(0, context.currentTime, EDGE_S);
      oscillator.stop(context.currentTime + 6 * EDGE_S);
    },
  };
}
