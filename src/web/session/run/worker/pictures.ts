import { changesOf, withChanges, type Changes } from '#core/changes';
import type { Snapshot } from '#simulation/snapshot';
import type { FromWorker } from './protocol';

type SnapshotMessage = Extract<FromWorker, { type: 'snapshot' }>;

/** A `snapshot` in transit: its changes since the last one. Reading all of it took the page longer than drawing it. */
interface Picture extends Omit<SnapshotMessage, 'type' | 'snapshot'> {
  readonly type: 'picture';
  readonly changes: Changes | undefined;
}

/** A message from the worker to the page in transit. */
export type OnItsWay = Exclude<FromWorker, SnapshotMessage> | Picture;

/** Packs the messages of one worker. */
export function packPictures(): (message: FromWorker) => OnItsWay {
  let last: unknown = null;
  return (message) => {
    if (message.type !== 'snapshot') return message;
    const { snapshot, type: _, ...rest } = message;
    const changes = changesOf(last, snapshot);
    last = withChanges(last, changes);
    return { ...rest, type: 'picture', changes };
  };
}

/** Unpacks the messages of that worker. Each snapshot is a new object; equal parts are shared with the last one. */
export function unpackPictures(): (message: OnItsWay | FromWorker) => FromWorker {
  let last: unknown = null;
  return (message) => {
    if (message.type !== 'picture') return message;
    const { changes, type: _, ...rest } = message;
    last = withChanges(last, changes);
    return { ...rest, type: 'snapshot', snapshot: { ...(last as Snapshot) } };
  };
}
