import { changesOf, withChanges, type Changes } from '#core/changes';
import type { Snapshot } from '#simulation/snapshot';
import type { FromWorker } from './protocol';

type SnapshotMessage = Extract<FromWorker, { type: 'snapshot' }>;

/** A `snapshot` on its way: what has changed since the last one. Reading all of it took the page longer than drawing it. */
interface Picture extends Omit<SnapshotMessage, 'type' | 'snapshot'> {
  readonly type: 'picture';
  readonly changes: Changes | undefined;
}

/** What goes from the worker to the page. */
export type OnItsWay = Exclude<FromWorker, SnapshotMessage> | Picture;

/** Packs what one worker says. */
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

/** Unpacks what that worker has said. Each snapshot is an object of its own; its parts are those of the last one where they say the same. */
export function unpackPictures(): (message: OnItsWay | FromWorker) => FromWorker {
  let last: unknown = null;
  return (message) => {
    if (message.type !== 'picture') return message;
    const { changes, type: _, ...rest } = message;
    last = withChanges(last, changes);
    return { ...rest, type: 'snapshot', snapshot: { ...(last as Snapshot) } };
  };
}
