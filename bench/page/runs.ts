import type { Figure, Subject } from '../subject';
import { chooseMaximumSpeed, pasteProgram, untilUsable, withPage, type Opened, type Stage } from './stage';
import { PLACES } from './watch';

const RUNS = 1_000;
/** The first look: what is made once has been made. */
const WARM = 10;
/** Growth that still counts as flat. Chosen: less than a kB for each run, and no node for every tenth. */
const FLAT = { heapMb: 1, nodes: 100 };

/** What the page itself holds, after a garbage collection. */
interface Held {
  readonly heapMb: number;
  readonly nodes: number;
  readonly listeners: number;
}

/** Whether the page stays as large as it is, however often a program is run. */
export const runsSubject: Subject<Stage> = {
  budgets: [{ what: 'the page after 10 and after 1,000 short runs', budget: 'flat' }],
  measure: (stage) =>
    withPage(stage, { noServiceWorker: true }, async (opened) => {
      const { page, tools } = opened;
      await untilUsable(page);
      await pasteProgram(page, 'print(1)');
      await chooseMaximumSpeed(page);
      await tools.send('Performance.enable');
      await run(opened, WARM);
      const first = await held(opened);
      await run(opened, RUNS - WARM);
      return [figure(first, await held(opened))];
    }),
};

/** Starts the program again and again, each time when it has printed, and stops it. */
async function run({ page }: Opened, times: number): Promise<void> {
  await page.evaluate(
    async ({ css, stop, runs }) => {
      const until = async (isSo: () => boolean): Promise<void> => {
        while (!isSo()) await new Promise((resolve) => setTimeout(resolve, 5));
      };
      for (let done = 0; done < runs; done += 1) {
        const before = window.bench.started;
        document.querySelector<HTMLElement>(css)?.click();
        await until(() => window.bench.started > before && window.bench.timeUs > 0);
        document.querySelector<HTMLElement>(stop)?.click();
        await until(() => document.querySelector<HTMLButtonElement>(stop)?.disabled !== false);
      }
    },
    { css: PLACES.run, stop: PLACES.stop, runs: times },
  );
}

async function held({ page, tools }: Opened): Promise<Held> {
  await page.waitForTimeout(1_000); // the worker of the next run
  await tools.send('HeapProfiler.collectGarbage');
  const { metrics } = await tools.send('Performance.getMetrics');
  const of = (wanted: string): number => metrics.find(({ name }) => name === wanted)?.value ?? NaN;
  return { heapMb: of('JSHeapUsedSize') / 1e6, nodes: of('Nodes'), listeners: of('JSEventListeners') };
}

function figure(first: Held, last: Held): Figure {
  const met = last.heapMb - first.heapMb <= FLAT.heapMb && last.nodes - first.nodes <= FLAT.nodes;
  const parts = [
    `heap ${first.heapMb.toFixed(1)} -> ${last.heapMb.toFixed(1)} MB`,
    `nodes ${String(first.nodes)} -> ${String(last.nodes)}`,
    `listeners ${String(first.listeners)} -> ${String(last.listeners)}`,
  ];
  return { text: `${met ? 'flat' : 'GROWING'}: ${parts.join(', ')}`, met };
}
