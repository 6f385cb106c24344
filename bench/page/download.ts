import { createServer, request, type IncomingMessage, type ServerResponse } from 'node:http';
import type { AddressInfo } from 'node:net';
import type { Subject } from '../subject';
import { untilMoving, untilUsable, withPage, type Stage } from './stage';

/** Budgets in kB. Of the page, 5 are for several devices, and 5 for looking back. */
const BUDGET_KB = { page: 300, all: 900 };

/** After this long the page has fetched what it wants before anybody does something. Chosen, in ms. */
const SETTLED_MS = 3_000;

/** The files that only a run needs. The page fetches them as soon as it is idle, so they count with the run. */
const OF_THE_RUN = /\.wasm$|\/worker[^/]*\.js$/;

/** How much a first visit downloads. */
export const downloadSubject: Subject<Stage> = {
  budgets: [
    { what: 'download, gzip: the page before Run', budget: '<= 300 kB' },
    { what: 'download, gzip: in all until the first run moves', budget: '<= 900 kB' },
  ],
  async measure(stage) {
    const before = await transfersOf(stage, false);
    const page = sum(before.filter(({ path }) => !OF_THE_RUN.test(path)));
    const transfers = await transfersOf(stage, true);
    const run = sum(transfers.filter(({ path }) => OF_THE_RUN.test(path)));
    const all = sum(transfers);
    return [
      { text: kilobytes(page), met: page <= BUDGET_KB.page * 1000 },
      { text: `${kilobytes(all)} (VM and worker ${kilobytes(run)})`, met: all <= BUDGET_KB.all * 1000 },
    ];
  },
};

/** The transfers of a visit that only looks at the page, or that presses Run and sees the robot move. */
async function transfersOf(stage: Stage, pressRun: boolean): Promise<readonly Transfer[]> {
  const scales = await weighing(stage.url);
  try {
    await withPage(stage, { url: scales.url, pressRun }, async ({ page }) => {
      if (pressRun) return untilMoving(page);
      await untilUsable(page);
      await page.waitForTimeout(SETTLED_MS);
    });
    return scales.transfers;
  } finally {
    await scales.close();
  }
}

interface Transfer {
  readonly path: string;
  /** Size of the body as it was sent. */
  readonly bytes: number;
}

const sum = (transfers: readonly Transfer[]): number => transfers.reduce((total, { bytes }) => total + bytes, 0);
const kilobytes = (bytes: number): string => `${(bytes / 1000).toFixed(1)} kB`;

/** Stands between the browser and the server, asks for gzip in the browser's name and weighs what comes. */
async function weighing(target: string) {
  const transfers: Transfer[] = [];
  const server = createServer((asked, answer) => {
    passOn(asked, answer, target, (bytes) => transfers.push({ path: asked.url ?? '/', bytes }));
  });
  await new Promise<void>((listening) => server.listen(0, '127.0.0.1', listening));
  const { port } = server.address() as AddressInfo;
  return {
    transfers,
    url: `http://localhost:${port}/`,
    close: () =>
      new Promise<void>((closed) => {
        server.close(() => closed());
        server.closeAllConnections();
      }),
  };
}

function passOn(asked: IncomingMessage, answer: ServerResponse, target: string, weigh: (bytes: number) => void): void {
  const headers = { ...asked.headers, 'accept-encoding': 'gzip' };
  const passed = request(new URL(asked.url ?? '/', target), { method: asked.method ?? 'GET', headers }, (got) => {
    let bytes = 0;
    got.on('data', (chunk: Buffer) => (bytes += chunk.length));
    got.on('end', () => weigh(bytes));
    answer.writeHead(got.statusCode ?? 502, got.headers);
    got.pipe(answer);
  });
  passed.on('error', () => answer.destroy());
  passed.end();
}
