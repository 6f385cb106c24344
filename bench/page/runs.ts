import type { Figure, Subject } from '../subject';
import { chooseMaximumSpeed, pasteProgram, untilUsable, withPage, type Opened, type Stage } from './stage';
import { PLACES } from './watch';

/** The runs after which is looked: what is made once is made by the first, the console is as full as it gets by the second. */
const LOOKS = [10, 100, 1_000];
/**
 * Growth from the second look to the last that still counts as flat. Chosen: a tenth of a kB a run, a node for each ninth;
 * measured on 2026-11-23 in one try: -0.012 MB of data.
 */
const FLAT = { dataMb: 0.1, nodes: 100 };

/**
 * Entries of a heap snapshot that are not the page's own data. For hundreds of runs the engine still compiles functions that
 * have become hot (0.9 MB from run 100 to 550), and the browser fills its lists of timings up to their limits.
 */
const NOT_DATA: readonly string[] = ['code', 'native'];

/** Memory of the page itself, after a garbage collection. */
interface Held {
  /** All of the JavaScript heap, with the code that the engine has compiled. */
  readonly heapMb: number;
  /** Objects, texts and functions alone. */
  readonly dataMb: number;
  readonly nodes: number;
  readonly listeners: number;
}

/** True if the page stays as large as it is, however often a program is run. */
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
  await page.evaluate(() => void (window.bench.frames = [])); // grows by itself
  await tools.send('HeapProfiler.collectGarbage');
  const { metrics } = await tools.send('Performance.getMetrics');
  const of = (wanted: string): number => metrics.find(({ name }) => name === wanted)?.value ?? NaN;
  const heap = { heapMb: of('JSHeapUsedSize') / 1e6, dataMb: dataBytes(await heapSnapshot(tools)) / 1e6 };
  return { ...heap, nodes: of('Nodes'), listeners: of('JSEventListeners') };
}

/** The part of Chromium's heap snapshots that is read here: `nodes` has as many numbers for each node as there are fields. */
interface HeapSnapshot {
  readonly snapshot: { readonly meta: { readonly node_fields: readonly string[]; readonly node_types: [string[]] } };
  readonly nodes: readonly number[];
}

async function heapSnapshot(tools: Opened['tools']): Promise<HeapSnapshot> {
  let text = '';
  const take = ({ chunk }: { readonly chunk: string }): void => void (text += chunk);
  tools.on('HeapProfiler.addHeapSnapshotChunk', take);
  await tools.send('HeapProfiler.takeHeapSnapshot', { reportProgress: false });
  tools.off('HeapProfiler.addHeapSnapshotChunk', take);
  return JSON.parse(text) as HeapSnapshot;
}

/** The sizes of all nodes that are the page's own data, summed. */
function dataBytes({ snapshot, nodes }: HeapSnapshot): number {
  const { node_fields: fields, node_types: types } = snapshot.meta;
  const [typeAt, sizeAt] = [fields.indexOf('type'), fields.indexOf('self_size')];
  let bytes = 0;
  for (let node = 0; node < nodes.length; node += fields.length)
    if (!NOT_DATA.includes(types[0][nodes[node + typeAt] ?? 0] ?? '')) bytes += nodes[node + sizeAt] ?? 0;
  return bytes;
}

function figure(found: readonly Held[]): Figure {
  const [full, last] = [found[1], found[2]];
  const met =
    full !== undefined &&
    last !== undefined &&
    last.dataMb - full.dataMb <= FLAT.dataMb &&
    last.nodes - full.nodes <= FLAT.nodes;
  const course = (of: (one: Held) => string): string => found.map(of).join(' -> ');
  const parts = [
    `data ${course(({ dataMb }) => dataMb.toFixed(2))} MB`,
    `heap with compiled code ${course(({ heapMb }) => heapMb.toFixed(1))} MB`,
    `nodes ${course(({ nodes }) => String(nodes))}`,
    `listeners ${course(({ listeners }) => String(listeners))}`,
  ];
  return { text: `${met ? 'flat' : 'GROWING'}: ${parts.join(', ')}`, met };
}
