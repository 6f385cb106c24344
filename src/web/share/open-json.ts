import { openJson } from '#project/open-json';

import type { PageParts } from '../page/parts';
import type { Workplace } from '../work/model/parts';
import { isOurs } from '../work/use-courses';
import { useOpenings } from '../work/use-openings';
import { isReadyArena } from '../work/catalogue/examples';
import { courseName } from '../work/catalogue/first-course';
import { say } from '../page/i18n/say';
import { reasonOf } from './problem-words';
import { shareWords as words } from './share-words';

/** Largest file of JSON that is read: a project with a picture as floor has a few MB. */
const MAX_BYTES = 16 * 1024 * 1024;

/**
 * Opens a project or a course from a file and puts the work so far aside. A file that cannot be opened gives a message.
 */
export async function openJsonFile(app: Workplace, loaded: File): Promise<void> {
  const file = loaded.name;
  if (!file.toLowerCase().endsWith('.json')) {
    refuse(app, say(words.problems.otherKind, { file }));
    return;
  }
  if (loaded.size > MAX_BYTES) {
    const size = Math.ceil(loaded.size / 1024 / 1024);
    refuse(app, say(words.problems.tooLargeFile, { file, size, max: MAX_BYTES / 1024 / 1024 }));
    return;
  }
  const text = await textOf(loaded);
  if (text === null) {
    refuse(app, say(words.problems.unreadable, { file }));
    return;
  }
  const opened = openJson(text);
  switch (opened.kind) {
    case 'project':
      useOpenings(app).open(
        opened.project,
        courseName(opened.project.scene, opened.project.course),
        isOurs(app.work.work.value.project),
        file.replace(/(\.parcours)?\.json$/i, ''),
      );
      return;
    case 'scene': {
      const { scene } = opened;
      const name = scene.name === '' ? file : scene.name;
      useOpenings(app).openScene({ scene, course: null }, name, isReadyArena(app.work.scene.value));
      return;
    }
    case 'problem':
      refuse(app, say(words.problems.file, { file, reason: reasonOf(opened.problems) }));
      return;
    default:
      opened satisfies never;
  }
}

function refuse(app: Pick<PageParts, 'notices'>, text: string): void {
  app.notices.show({ kind: 'error', key: 'notice.text', values: { text } });
}

async function textOf(file: File): Promise<string | null> {
  try {
    return new TextDecoder('utf-8', { fatal: true }).decode(await file.arrayBuffer());
  } catch {
    return null;
  }
}
