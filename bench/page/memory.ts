import type { Page } from '@playwright/test';
import type { Figure, Subject } from '../subject';
import { closedLine, eightDevices } from './kept-work';
import { chooseMaximumSpeed, until, untilUsable, withPage, type Opened, type Stage } from './stage';
import { PLACES } from './watch';
import { memoryUse, noteVms, type MemoryUse } from './worker-memory';

const RESTARTS = 100;
/** Eight devices have eight virtual machines of 4 MB, half of it never touched. */
const BUDGETS_MB = { one: 80, eight: 160 };
/** Number of memory measurements on the way; the first one is after the warm-up. */
const LOOKS = 4;
/**
 * Growth between the first look and the last that still counts as flat: a share, and some MB for chance. The process
 * gives back what ended workers had when it likes: with nothing growing it was seen to vary by 13 MB.
 */
const FLAT = { share: 0.05, heapMb: 1, processMb: 15 };

/**
 * Memory that the page uses to look back, in MB for ten minutes and device: the tape 0.2 (decision 0049), printed
 * text the rest.
 */
const KEPT_MB = 0.4;

/** True if memory stays what it is: with one device, and with eight. */
export const memorySubject = memoryOf('', closedLine, 600_000_000, BUDGETS_MB.one, 1);
export const eightDevicesMemorySubject = memoryOf(', eight devices', eightDevices, 1_440_000_000, BUDGETS_MB.eight, 8);

function memoryOf(
  who: string,
  work: () => string,
  drivingUs: number,
  budgetMb: number,
  devices: number,
): Subject<Stage> {
  const keptMb = (KEPT_MB * devices * drivingUs * (1 - 1 / LOOKS)) / 600_000_000;
  const budget = `flat, <= ${budgetMb} MB`;
  return {
    budgets: [
      { what: `worker memory, ${drivingUs / 60_000_000} min of driving${who}`, budget },
      { what: `worker memory, ${RESTARTS} restarts${who}`, budget },
    ],
    measure: (stage) =>
      withPage(stage, { noServiceWorker: true, work: work() }, async (opened) => {
        noteVms(opened.page);
        await untilUsable(opened.page);
        await settle(opened.page);
        if (!stage.long) await chooseMaximumSpeed(opened.page);
        const driving = await drive(opened, drivingUs);
        const restarting = await restart(opened);
        return [figure(driving, budgetMb, keptMb), figure(restarting, budgetMb, 0)];
      }),
  };
}

/** One long run. */
async function drive(opened: Opened, drivingUs: number): Promise<MemoryUse[]> {
  const { page } = opened;
  await page.click(PLACES.run);
  return looks(async (look) => {
    const wantedUs = (look * drivingUs) / LOOKS;
    await until(page, (us) => window.bench.timeUs >= us, wantedUs, drivingUs / 1000);
    return memoryUse(opened);
  });
}

/** Presses Run again and again, each time when the run before has begun to move. */
function restart(opened: Opened): Promise<MemoryUse[]> {
  return looks(async () => {
    await opened.page.evaluate(restarts, { css: PLACES.run, times: RESTARTS / LOOKS - 1 });
    await settle(opened.page);
    await opened.page.evaluate(restarts, { css: PLACES.run, times: 1 });
    return memoryUse(opened);
  });
}

/** Lets the page make the worker of the next run, so that its VM is noted. */
const settle = (page: Page): Promise<void> => page.waitForTimeout(1_000);

/** In the page. */
async function restarts({ css, times }: { readonly css: string; readonly times: number }): Promise<void> {
  for (let restart = 0; restart < times; restart++) {
    const before = window.bench.started;
    document.querySelector<HTMLElement>(css)?.click();
    while (window.bench.started === before || window.bench.timeUs === 0)
      await new Promise((resolve) => setTimeout(resolve, 10));
  }
}

async function looks(use: (look: number) => Promise<MemoryUse>): Promise<MemoryUse[]> {
  const uses: MemoryUse[] = [];
  while (uses.length < LOOKS) uses.push(await use(uses.length + 1));
  return uses;
}

/** @param keptMb by how much the page may have grown, for what it keeps */
function figure(uses: readonly MemoryUse[], budgetMb: number, keptMb: number): Figure {
  const worker = uses.map(({ workerMb }) => workerMb);
  const page = uses.map(({ pageMb }) => pageMb);
  const inAll = uses.map(({ processMb }) => processMb).filter((mb) => mb !== null);
  const isFlat = flat(worker, FLAT.heapMb) && flat(page, FLAT.heapMb + keptMb) && flat(inAll, FLAT.processMb + keptMb);
  const parts = [
    `${isFlat ? 'flat' : 'GROWING'}: worker ${course(worker, 1)} MB`,
    `page ${course(page, 1)} MB`,
    ...(inAll.length > 0 ? [`process ${course(inAll, 0)} MB`] : []),
    `${uses.at(-1)?.workers ?? 0} workers`,
  ];
  return { text: parts.join(', '), met: isFlat && Math.max(...worker) <= budgetMb };
}

function flat(sizesMb: readonly number[], chanceMb: number): boolean {
  const first = sizesMb[0] ?? 0;
  return (sizesMb.at(-1) ?? 0) <= first * (1 + FLAT.share) + chanceMb;
}

const course = (sizesMb: readonly number[], digits: number): string =>
  `${sizesMb[0]?.toFixed(digits) ?? '-'} -> ${sizesMb.at(-1)?.toFixed(digits) ?? '-'}`;
