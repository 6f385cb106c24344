import type { Source } from '#intake/sources';

import type { AddedFile } from '../page/files/added-files';
import { HandInReader } from '../run/reading/hand-in-reader';
import { readyCourses } from '../work/catalogue/ready-courses';

const reader = new HandInReader(() => Object.fromEntries(readyCourses.map(({ id, scene }) => [id, scene])));

/** The hand-ins of files and folders that were chosen or dropped, each as the command line takes it; they are read in a worker. */
export const sourcesOf = (added: readonly AddedFile[]): Promise<readonly Source[]> => reader.open(added);
