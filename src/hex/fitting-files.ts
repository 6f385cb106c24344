import type { SourceFile } from '#project/project';
import { smallerPython } from '#python/smaller';
import { filesForDevice, type DeviceFiles } from './device-files';
import { storedBytes } from './file-system';

/** The files for a board's file system. */
export interface FittingFiles extends DeviceFiles {
  /** Libraries of ours that were written in fewer letters, because they would not have fitted otherwise. */
  readonly smaller: readonly string[];
}

/**
 * The pupil's files and just the libraries that they import. If all of it does not fit, the libraries lose their comments
 * and spaces; the pupil's own files stay as they are.
 *
 * @param robot id of the robot that the program drives, or `null`
 */
export function fittingFiles(own: readonly SourceFile[], robot: string | null, roomBytes: number): FittingFiles {
  const { files, modules } = filesForDevice(own, robot);
  if (sumOf(files) <= roomBytes) return { files, modules, smaller: [] };
  const shorter = files.map((file) => (file.isOwn ? file : { ...file, text: smallerPython(file.text) }));
  return { files: shorter, modules, smaller: shorter.filter(({ isOwn }) => !isOwn).map(({ name }) => name) };
}

const sumOf = (files: readonly SourceFile[]): number =>
  files.reduce((sum, { name, text }) => sum + storedBytes(name, new TextEncoder().encode(text)), 0);
