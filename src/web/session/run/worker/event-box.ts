import type { SoundEvent } from '#board/sound/sound-event';
import type { DeviceOutlets, RadioPacket, RunOutlets, TimedLogEvent } from '#simulation/outlets';

/** The events of a device since the last call, oldest first. */
export interface RunEvents {
  readonly sound: readonly SoundEvent[];
  readonly radio: readonly RadioPacket[];
  /** Packets that were dropped before these: the program sent more than anyone could read. */
  readonly radioDropped: number;
  readonly log: readonly TimedLogEvent[];
}

/** Collects a device's events for the page. */
export interface EventBox {
  readonly outlets: DeviceOutlets;
  /** Takes out the robot's path: x and y in mm alternately, two `NaN` where the hand tool lifted it. */
  takeTrail(): readonly number[];
  /** Takes out everything else, or `null` when there is nothing. */
  take(): RunEvents | null;
}

/**
 * Number of newest packets that remain when twice as many have gathered. Chosen: as many as the page shows at a time.
 */
const MAX_PACKETS = 200;
/** The same for sound events (a batch is a frame): at 1 × a melody makes one, at full speed sound does not matter. */
const MAX_SOUNDS = 500;

/** The same for points of the path, which gather for instance while the page is hidden. Chosen: 60 m. */
const MAX_POINTS = 15_000;

/**
 * Creates a box. It holds all rows of the data log, because the log itself is bounded, and the newest packets, sounds
 * and points of the path.
 */
export function createEventBox(): EventBox {
  let sound: SoundEvent[] = [];
  let radio: RadioPacket[] = [];
  let radioDropped = 0;
  let log: TimedLogEvent[] = [];
  let trail: number[] = [];
  return {
    outlets: {
      sound: (event) => {
        sound.push(event);
        if (sound.length > 2 * MAX_SOUNDS) sound = sound.slice(-MAX_SOUNDS);
      },
      radio: (packet) => {
        radio.push(packet);
        if (radio.length <= 2 * MAX_PACKETS) return;
        radioDropped += radio.length - MAX_PACKETS;
        radio = radio.slice(-MAX_PACKETS);
      },
      log: (event) => {
        if (event.type === 'clear') log = [];
        log.push(event);
      },
      trail: (point) => {
        trail.push(point?.x ?? NaN, point?.y ?? NaN);
        if (trail.length > 4 * MAX_POINTS) trail = trail.slice(-2 * MAX_POINTS);
      },
    },
    takeTrail() {
      const taken = trail;
      trail = [];
      return taken;
    },
    take() {
      if (sound.length + radio.length + log.length === 0) return null;
      const events = { sound, radio, radioDropped, log };
      sound = [];
      radio = [];
      radioDropped = 0;
      log = [];
      return events;
    },
  };
}

/** One box for each device of a run, by its place. */
export interface EventBoxes {
  readonly outlets: Omit<RunOutlets, 'print'>;
  takeTrails(): readonly (readonly number[])[];
  take(): readonly { readonly device: number; readonly events: RunEvents }[];
}

/** Creates boxes for this number of devices. */
export function createEventBoxes(devices: number): EventBoxes {
  const boxes = Array.from({ length: devices }, createEventBox);
  return {
    outlets: {
      sound: (event, device) => boxes[device]?.outlets.sound?.(event),
      radio: (packet, device) => boxes[device]?.outlets.radio?.(packet),
      log: (event, device) => boxes[device]?.outlets.log?.(event),
      trail: (point, device) => boxes[device]?.outlets.trail?.(point),
    },
    takeTrails: () => boxes.map((box) => box.takeTrail()),
    take: () =>
      boxes.flatMap((box, device) => {
        const events = box.take();
        return events === null ? [] : [{ device, events }];
      }),
  };
}
