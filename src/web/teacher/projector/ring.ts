import type { SoundOutput, SoundPlayer } from '../../session/run/sound/sound-player';

/** A soft gong: pitch in Hz, loudness 0 … 1, length and pause in s. Chosen: heard in a room at work, startles nobody; over before the sound system falls asleep. */
const GONG = { hz: [660, 990], gain: 0.25, seconds: 1.2, everySeconds: 0.7 } as const;
/**
 * Number of attempts to get the sound system, which may have to be loaded and woken first, and the time between them in
 * ms.
 */
const ASKED = { times: 25, everyMs: 120 } as const;

/** Sounds a gong; not while the page is muted. */
export async function ring(sound: Pick<SoundPlayer, 'output'>, times = 3): Promise<void> {
  for (let asked = 0; asked < ASKED.times; asked += 1) {
    const out = sound.output();
    if (out !== null) {
      for (let one = 0; one < times; one += 1) strike(out, one * GONG.everySeconds);
      return;
    }
    await new Promise((resolve) => setTimeout(resolve, ASKED.everyMs));
  }
}

function strike({ context, to }: SoundOutput, afterSeconds: number): void {
  const at = context.currentTime + afterSeconds;
  for (const hz of GONG.hz) {
    const oscillator = context.createOscillator();
    const gain = context.createGain();
    oscillator.frequency.value = hz;
    gain.gain.setValueAtTime(GONG.gain / GONG.hz.length, at);
    gain.gain.setTargetAtTime(0, at, GONG.seconds / 4);
    oscillator.connect(gain).connect(to);
    oscillator.start(at);
    oscillator.stop(at + GONG.seconds);
  }
}
