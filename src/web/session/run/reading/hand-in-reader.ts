import { brokenSource, type Source } from '#intake/sources';
import { unread, type Unread } from '#check/hand-in/unread';
import type { Content } from '#intake/contents';
import type { SeriesAmong } from '#intake/series-among';
import type { Every } from '#check/lane';
import type { Scene } from '#scene/scene';

import type { AddedFile } from '../../../kit/files/added-files';
import { every } from '../serve-thread';
import { createWorker } from '../worker/create-worker';
import type { FromReader, ToReader } from '../worker/reader';

/** A worker that reads. */
export interface ReaderThread {
  send(message: ToReader): void;
  stop(): void;
}

/** The page's services that reading uses. */
export interface ReaderPorts {
  /** Starts a worker; `heard` receives each answer, `failed` the reason for its end; empty: its code did not come. */
  start(heard: (answer: FromReader) => void, failed: (problem: string) => void): ReaderThread;
  readonly every: Every;
}

const LOOK_MS = 200;

/**
 * Time limit for reading one hand-in before it is tried once more, in ms. Chosen: a hundred times the time for 4 MB on
 * a tablet.
 */
export const READ_MS = 20_000;

/** Problems that may not come a second time: the machine was busy, or a part of the code did not come. */
const AGAIN: readonly Unread['code'][] = ['slow', 'unloaded'];

/** Files that were handed in together. */
interface Batch {
  readonly number: number;
  readonly added: readonly AddedFile[];
}

/** The hand-ins in a class's files, and the series if there is one. */
export interface OpenedHandIns {
  readonly series: SeriesAmong['document'] | null;
  readonly sources: readonly Source[];
}

/**
 * Reads hand-ins beside the page, one after the other. One that does not finish, or whose reader does not come, is tried a
 * second time in a new worker. If it fails again, it is reported, and the others follow.
 */
export class HandInReader {
  private thread: ReaderThread | null = null;
  private readonly opened = new Set<number>();
  private batches = 0;
  private last: Promise<unknown> = Promise.resolve();
  private hear: ((answer: FromReader | { readonly problem: Unread }) => void) | null = null;

  constructor(
    private readonly scenes: () => Readonly<Record<string, Scene>>,
    private readonly ports: ReaderPorts = inWorker,
  ) {}

  /** The hand-ins of files and folders, each read in its turn; a series among them is read immediately. */
  async open(added: readonly AddedFile[]): Promise<OpenedHandIns> {
    const batch: Batch = { number: (this.batches += 1), added };
    const answer = await this.inTurn(() => this.twice(() => this.names(batch)));
    if ('problem' in answer)
      return { series: null, sources: added.map(({ path }) => brokenSource(path, answer.problem)) };
    const { names, series } = answer;
    return { series, sources: names.map((name, place) => ({ name, read: () => this.read(batch, place) })) };
  }

  private async read(batch: Batch, place: number): Promise<Content> {
    const answer = await this.inTurn(() => this.twice(() => this.content(batch, place)));
    return 'problem' in answer ? answer : answer.content;
  }

  private async names(batch: Batch): Promise<Extract<FromReader, { type: 'read-names' }> | Problem> {
    const { number, added } = batch;
    const answer = await this.ask({ type: 'read-open', batch: number, added, scenes: this.scenes() });
    if ('problem' in answer) return answer;
    if (answer.type !== 'read-names') return OUT_OF_ORDER;
    this.opened.add(number);
    return answer;
  }

  private async content(batch: Batch, place: number): Promise<Extract<FromReader, { type: 'read-content' }> | Problem> {
    // A new worker does not know the files opened in an earlier one.
    const opened = this.opened.has(batch.number) ? null : await this.names(batch);
    if (opened !== null && 'problem' in opened) return opened;
    const answer = await this.ask({ type: 'read', batch: batch.number, place });
    return 'problem' in answer || answer.type === 'read-content' ? answer : OUT_OF_ORDER;
  }

  private async twice<T extends object>(attempt: () => Promise<T | Problem>): Promise<T | Problem> {
    const first = await attempt();
    return 'problem' in first && AGAIN.includes(first.problem.code) ? attempt() : first;
  }

  private inTurn<T>(work: () => Promise<T>): Promise<T> {
    const turn = this.last.then(work);
    this.last = turn.catch(() => undefined);
    return turn;
  }

  private ask(message: ToReader): Promise<FromReader | Problem> {
    return new Promise((resolve) => {
      let passedMs = 0;
      const unwatch = this.ports.every(LOOK_MS, () => {
        passedMs += LOOK_MS;
        if (passedMs > READ_MS) this.lose(unread('slow', { seconds: READ_MS / 1000 }));
      });
      this.hear = (answer) => {
        unwatch();
        this.hear = null;
        resolve(answer);
      };
      try {
        this.thread ??= this.ports.start(
          (answer) => (answer.type === 'read-unloaded' ? this.lose(unread('unloaded')) : this.hear?.(answer)),
          (problem) => this.lose(problem === '' ? unread('unloaded') : unread('broken', { problem })),
        );
        this.thread.send(message);
      } catch (error) {
        this.lose(unread('broken', { problem: error instanceof Error ? error.message : String(error) }));
      }
    });
  }

  /** Gives the worker up, with all that it had open. */
  private lose(problem: Problem): void {
    this.thread?.stop();
    this.thread = null;
    this.opened.clear();
    this.hear?.(problem);
  }
}

type Problem = { readonly problem: Unread };

const OUT_OF_ORDER: Problem = unread('broken', { problem: 'The reader has answered something else.' });

/** A worker of the page. */
const inWorker: ReaderPorts = {
  start(heard, failed) {
    const worker = createWorker();
    worker.onmessage = ({ data }: MessageEvent<FromReader>) => heard(data);
    worker.onerror = ({ message }: Partial<ErrorEvent>) => failed(message ?? '');
    return { send: (message) => worker.postMessage(message), stop: () => worker.terminate() };
  },
  every,
};
