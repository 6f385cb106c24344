import type { Figure, Subject } from '../subject';
import { chooseMaximumSpeed, pasteProgram, untilUsable, withPage, type Opened, type Stage } from './stage';
import { PLACES } from './watch';

/** The runs after which is looked: what is made once is made by the first, the console is as full as it gets by the second. */
const LOOKS = [10, 100, 1_000];
/** Growth from the second look to the last that still counts as flat. Chosen: about a kB a run, a node for each ninth. */
const FLAT = { heapMb: 1, nodes: 100 };

/** What the page itself holds, after a garbage collection. */
interface Held {
  readonly heapMb: number;
  readonly nodes: number;
  readonly listeners: number;
}

/** Whether the page stays as large as it is, however often a program is run. */
export const runsSubject: Subject<Stage> = {
  budgets: [{ what: 'the page after 10, 100 and 1,000 short runs', budget: 'flat' }],
  measure: (stage) =>
    withPage(stage, { noServiceWorker: true }, async (opened) => {
      const { page, tools } = opened;
      await untilUsable(page);
      await pasteProgram(page, 'print(1)');
      await chooseMaximumSpeed(page);
      await tools.send('Performance.enable');
      const found: Held[] = [];
      for (const [look, runs] of LOOKS.entries()) {
        await run(opened, runs - (LOOKS[look - 1] ?? 0));
        found.push(await held(opened));
      }
      return [figure(found)];
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

function figure(found: readonly Held[]): Figure {
  const [full, last] = [found[1], found[2]];
  const met =
    full !== undefined &&
    last !== undefined &&
    last.heapMb - full.heapMb <= FLAT.heapMb &&
    last.nodes - full.nodes <= FLAT.nodes;
  const course = (of: (one: Held) => string): string => found.map(of).join(' -> ');
  const parts = [
    `heap ${course(({ heapMb }) => heapMb.toFixed(1))} MB`,
    `nodes ${course(({ nodes }) => String(nodes))}`,
    `listeners ${course(({ listeners }) => String(listeners))}`,
  ];
  return { text: `${met ? 'flat' : 'GROWING'}: ${parts.join(', ')}`, met };
}
