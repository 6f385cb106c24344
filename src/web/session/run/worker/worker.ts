/**
 * The worker that owns one run, inspects a past one or repeats it (`look/`), fits one robot (`fit.ts`), serves beside a run
 * (`serve/`: checks, runs by the hundred, hints), reads hand-ins (`reader.ts`), makes a film (`film.ts`) or a hex (`hex.ts`). A run exchanges the messages of
 * `protocol.ts`; its logic is in `runner.ts`.
 */
import '../../../kit/oldest/fill';

import { Simulation } from '#simulation/simulation';

import type { FromFilm, ToFilm } from './film';
import type { FitAnswer, FitRequest } from './fit';
import type { HexAnswer, HexRequest } from './hex';
import type { FromLooker, ToLooker } from './look/protocol';
import type { RepeatAnswer, RepeatRequest } from './look/repeat';
import type { FromReader, ToReader } from './reader';
import { sealSandbox } from './sandbox';
import { packPictures } from './pictures';
import type { ToWorker } from './protocol';
import { Runner } from './runner';
import type { FromServer, ToServer } from './serve/protocol';

sealSandbox(globalThis);

// A message to itself arrives immediately, but after the messages already waiting: setTimeout would add 4 ms each time.
const channel = new MessageChannel();
let next: (() => void) | null = null;
channel.port1.onmessage = () => {
  const task = next;
  next = null;
  task?.();
};

function soon(task: () => void): void {
  next = task;
  channel.port2.postMessage(null);
}

const nowMs = (): number => performance.now();
const pack = packPictures();
const runner = new Runner({
  post: (message) => postMessage(pack(message)),
  nowMs,
  later(task, delayMs) {
    if (delayMs > 0) setTimeout(task, delayMs);
    else soon(task);
  },
  create: (setup, firmware, outlets) => Simulation.create(setup, firmware, outlets),
});

/** A part that no run needs, loaded when it is first asked for. One that did not come is fetched again the next time. */
function late<Part>(load: () => Promise<Part>): () => Promise<Part> {
  let part: Promise<Part> | null = null;
  return () =>
    (part ??= load().catch((error: unknown) => {
      part = null;
      throw error;
    }));
}

const post = (message: unknown): void => postMessage(message);
const rest = (): Promise<void> => new Promise((resolve) => soon(resolve));

const loadLooker = late(() => import('./look/looker').then(({ Looker }) => new Looker({ post, nowMs, rest })));
const loadServer = late(() => import('./serve/server').then(({ Server }) => new Server({ post, nowMs })));
const loadReader = late(() => import('./reader').then(({ Reader }) => new Reader()));
const loadFilmMaker = late(() => import('./film').then(({ createFilmMaker }) => createFilmMaker(post)));

const isForLooker = (data: Asked): data is ToLooker =>
  data.type === 'why' || data.type === 'look-into' || data.type === 'look' || data.type === 'look-near';

type Asked = ToWorker | ToLooker | RepeatRequest | FitRequest | HexRequest | ToServer | ToReader | ToFilm;

addEventListener('message', ({ data }: MessageEvent<Asked>) => {
  if (data.type === 'repeat')
    void import('./look/repeat').then(
      (late) => late.answerRepeat(data, { post, nowMs }),
      (error: unknown) => postMessage({ type: 'failed', message: String(error) } satisfies RepeatAnswer),
    );
  else if (data.type === 'fit')
    void import('./fit')
      .then(({ answerFit }) => answerFit(data))
      .catch((error: unknown): FitAnswer => ({ type: 'failed', message: String(error) }))
      .then((answer) => postMessage(answer));
  else if (data.type === 'make-hex')
    void import('./hex')
      .then(({ answerHex }) => answerHex(data))
      .catch((error: unknown): HexAnswer => ({ type: 'failed', message: String(error) }))
      .then((answer) => postMessage(answer));
  else if (isForLooker(data))
    void loadLooker().then(
      (it) => it.receive(data),
      (error: unknown) => postMessage({ type: 'look-failed', message: String(error) } satisfies FromLooker),
    );
  else if (data.type === 'serve-open' || data.type === 'serve')
    void loadServer().then(
      (it) => it.receive(data),
      () => {
        // Whoever asks hears that its code did not come; a program is not to blame.
        if (data.type === 'serve') postMessage({ type: 'served', answer: { unloaded: true } } satisfies FromServer);
      },
    );
  else if (data.type === 'read-open' || data.type === 'read')
    void loadReader()
      .then((it) => it.answer(data))
      .catch((): FromReader => ({ type: 'read-unloaded' }))
      .then((answer) => postMessage(answer));
  else if (data.type === 'film-begin' || data.type === 'film-picture' || data.type === 'film-end')
    void loadFilmMaker().then(
      (tell) => tell(data),
      (error: unknown) => postMessage({ type: 'film-failed', message: String(error) } satisfies FromFilm),
    );
  else runner.receive(data);
});
