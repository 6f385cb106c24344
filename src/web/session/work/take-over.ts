/**
 * The works of tabs that were closed. A new tab opens what the last one has left; what lies under the names of the others
 * goes to its earlier works, so that none is out of reach.
 */
import { filesByDevice, keepLast } from './programs/own-programs';
import { withAll } from './storage/all-works';
import { dropCopies, laterCopies } from './storage/copies';
import { savedMsOf, type Previous } from './storage/history';
import { wholeWork } from './storage/large-work';
import { workFromText } from './storage/read-work';
import { tabName } from './storage/tab-storage';
import { courseName } from './catalogue/first-course';
import { lateModel, type WithLate } from '../../kit/state/late-models';
import type { WorkParts } from './model/parts';
import type { WorkModel } from './model/work-model';
import { nameWithFile } from './work-name';
import { hasNothingOwn } from './use-courses';

/** Prefix of the lock of an open tab: see `keep-work.ts`. */
const LOCK = 'parcours.tab.';

/** Number of copies of closed tabs that stay though their works are taken over. Chosen: tabs that a browser brings back. */
const KNOWN_COPIES = 5;

const takingOver = lateModel((): { going?: Promise<void> } => ({}));

/**
 * Adds the works that closed tabs have left to the earlier works of this one, once. A page that stores nothing takes
 * none.
 */
export function takeOver(app: Pick<WorkParts, 'work'> & WithLate, nowMs: number): Promise<void> {
  const { work } = app;
  if (work.programs === null) return Promise.resolve();
  return (takingOver(app).going ??= leftWorks(nowMs)
    .then((left) => takeAll(work, left))
    .catch(() => undefined)); // a browser that forbids storage has left nothing
}

/** The works under the name of a tab, and when it saved them. */
interface Left {
  readonly tab: string;
  readonly savedMs: number;
  readonly works: readonly Previous[];
}

/**
 * Takes the works over. Copies from which nothing new came are in the list that is stored: of those only the newest stay,
 * for a browser that brings its tabs back.
 */
function takeAll(work: WorkModel, left: readonly Left[]): Promise<void> {
  const known = left.filter(({ works }) => !put(work, works)).sort((one, other) => other.savedMs - one.savedMs);
  return dropCopies(known.slice(KNOWN_COPIES).map(({ tab }) => tab));
}

/** @returns whether any of the works is new here */
function put(work: WorkModel, left: readonly Previous[]): boolean {
  const before = work.work.value;
  const gone = (before.deleted ?? []).map(({ project }) => project);
  const previous = withAll(before.previous, left, [before.project, ...gone]);
  if (previous !== before.previous) work.work.value = { ...before, previous };
  for (const { project, atMs } of left)
    if (project.course !== null && project.task === undefined)
      keepLast(work, project.course, { atMs, files: filesByDevice(project) });
  return previous !== before.previous;
}

async function leftWorks(nowMs: number): Promise<readonly Left[]> {
  const open = await openTabs();
  const own = tabName(sessionStorage);
  if (own !== null) open.add(own);
  const closed = [...(await laterCopies())].filter(([tab]) => !open.has(tab));
  // A copy that cannot be read hides no other, and stays.
  const read = closed.map(([tab, text]) =>
    worksIn(text, nowMs).then(
      (works): Left[] => [{ tab, savedMs: savedMsOf(text), works }],
      () => [],
    ),
  );
  return (await Promise.all(read)).flat();
}

async function worksIn(text: string, nowMs: number): Promise<readonly Previous[]> {
  const work = workFromText(await wholeWork(text, nowMs));
  if (work === null) return [];
  const { project, file, previous } = work;
  const name = nameWithFile(courseName(project.scene, project.course), file);
  const open = { name, atMs: savedMsOf(text), project, ...(file !== undefined && { file }) };
  return [open, ...previous]
    .filter((entry) => !hasNothingOwn(entry.project))
    .map((entry) => ({ ...entry, isOfTab: true }));
}

/** The names of the tabs that are open; where they cannot be known, their works count as left, and are listed once more. */
async function openTabs(): Promise<Set<string>> {
  const locks = (navigator as Partial<Navigator>).locks;
  const { held = [] } = (await locks?.query()) ?? {};
  return new Set(held.map(({ name = '' }) => name.replace(LOCK, '')));
}
