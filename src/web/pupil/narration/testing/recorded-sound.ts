import type { SoundOutput } from '../../../session/run/sound/sound-player';

/** A sound system that plays nothing and records the requests. */
export interface RecordedSound {
  readonly output: SoundOutput;
  /** The sounds started, changed and stopped: `beep 700`, `line 327`, `pan 0`, `line ends`. */
  readonly heard: string[];
  /** Advances the time of the sound system, in s. */
  readonly pass: (s: number) => void;
}

/** Makes a recorded sound system, as Node and Happy DOM have no Web Audio. */
export function recordedSound(): RecordedSound {
  const heard: string[] = [];
  const clock = { currentTime: 0 };
  const param = (set: (value: number) => void = () => undefined) => ({
    value: 0,
    setTargetAtTime: (value: number) => set(value),
  });
  const joined = (node: object): object => Object.assign(node, { connect: (to: object) => to });
  const createOscillator = () => {
    let isLine = false;
    let hz = 0;
    return joined({
      set type(_: string) {
        isLine = true;
      },
      frequency: { ...param((value) => heard.push(`line ${String(value)}`)), set value(value: number) { hz = value; } }, // prettier-ignore
      start: () => isLine || heard.push(`beep ${String(hz)}`),
      stop: () => isLine && heard.push('line ends'),
    });
  };
  const context = Object.assign(clock, {
    createOscillator,
    createGain: () => joined({ gain: param() }),
    createStereoPanner: () => joined({ pan: param((value) => heard.push(`pan ${String(value)}`)) }),
  });
  return {
    output: { context, to: {} } as unknown as SoundOutput,
    heard,
    pass: (s) => void (clock.currentTime += s),
  };
}
