import { deviceNames, placeOfFiles } from '#project/devices';
import type { Project } from '#project/project';

/** Distinguishes a file from those of the same name on other devices. @param place of the device that has it */
export const fileKey = (project: Project, place: number, name: string): string =>
  `${deviceNames(project)[placeOfFiles(project, place)] ?? ''}/${name}`;
