import { projectToText } from '#project/file';
import type { Project } from '#project/project';
import { serializeScene } from '#scene/serialize';

import type { PageParts } from '../../kit/parts';
import type { WorkParts } from './model/parts';
import { saveText } from './save-file';
import { nameToSave, workName } from './work-name';
import { fileName } from './save-file';
import { travelling } from './settings/travelling';

/** The present work with the settings of its run, to be saved or shared. */
export function presentProject({ work, settings }: WorkParts): Project {
  return { ...work.work.value.project, settings: travelling(settings.current.value) };
}

/**
 * Saves everything as one file.
 *
 * @param project left out: the present work
 * @param name name of the file; left out: that of the work
 */
export function saveProject(
  app: Pick<PageParts, 'notices'> & WorkParts,
  project = presentProject(app),
  name = nameToSave(app),
): void {
  saveText(app, fileName(name, 'parcours.json'), projectToText(project), 'application/json');
}

/** Saves the course alone. */
export function saveScene(app: Pick<PageParts, 'notices'> & Pick<WorkParts, 'work'>): void {
  saveText(app, fileName(workName(app), 'json'), serializeScene(app.work.scene.value), 'application/json');
}
