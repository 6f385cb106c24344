import type { Board } from '#board/board';
import type { LogEvent } from '#board/data-log';
import type { SoundEvent } from '#board/sound/sound-event';
import type { Clock } from '#core/clock';
import type { OutputSet } from './causes/output';
import type { Snapshot } from './snapshot';
import type { TrailPoint } from './trail';

/** A packet that the program sent by radio. */
export interface RadioPacket {
  /** Simulated time. */
  readonly timeUs: number;
  /** 0 … 255; only boards in the same group hear it. */
  readonly group: number;
  /** As it is on the air: `radio.send` puts 1, 0, 1 before the UTF-8 of its text. */
  readonly bytes: readonly number[];
}

/** An event of the board's data log. */
export type TimedLogEvent = LogEvent & {
  /** Simulated time. */
  readonly timeUs: number;
};

/** The listeners for one device's events, called the moment they happen. Events without a listener are not even made. */
export interface DeviceOutlets {
  /** Output of the program; left out, it is kept for `takeConsole`. */
  readonly print?: (text: string) => void;
  readonly sound?: (event: SoundEvent) => void;
  readonly radio?: (packet: RadioPacket) => void;
  readonly log?: (event: TimedLogEvent) => void;
  /** The robot's path, a point every few mm. */
  readonly trail?: (point: TrailPoint) => void;
  /** Each time that the program sets an output, with the lines that do it. */
  readonly set?: (set: OutputSet) => void;
}

/** The listeners for a run's events; `device` is the place of the one they come from in the set-up. */
export interface RunOutlets {
  readonly print?: (text: string, device: number) => void;
  readonly sound?: (event: SoundEvent, device: number) => void;
  readonly radio?: (packet: RadioPacket, device: number) => void;
  readonly log?: (event: TimedLogEvent, device: number) => void;
  readonly trail?: (point: TrailPoint, device: number) => void;
  readonly set?: (set: OutputSet, device: number) => void;
  /** Called at the beginning and after every step of the world, once the judge has looked; the run can then be read. */
  readonly step?: () => void;
  /** Receives the state of the run every 20 ms of simulated time, after the world has moved. */
  readonly moment?: (snapshot: Snapshot) => void;
  /** True if the moment at this time is wanted; one that is not is not even made. Left out: all are. */
  readonly isMomentWanted?: (timeUs: number) => boolean;
}

/** The listeners for the events of one device. */
export function outletsOf({ print, sound, radio, log, trail, set }: RunOutlets, device: number): DeviceOutlets {
  return {
    ...(print && { print: (text) => print(text, device) }),
    ...(sound && { sound: (event) => sound(event, device) }),
    ...(radio && { radio: (packet) => radio(packet, device) }),
    ...(log && { log: (event) => log(event, device) }),
    ...(trail && { trail: (point) => trail(point, device) }),
    ...(set && { set: (each) => set(each, device) }),
  };
}

/** Passes on the board's events to the outlets that are given. */
export function tellEvents(board: Board, clock: Clock, { sound, radio, log }: DeviceOutlets): void {
  if (sound) board.sound.onEvent(sound);
  if (radio)
    board.radio.onSend((packet) => radio({ timeUs: clock.nowUs, group: board.radio.group, bytes: Array.from(packet) }));
  if (log) board.dataLog.onEvent((event) => log({ ...event, timeUs: clock.nowUs }));
}
