import type { Parcours, ProjectFile, SceneFile } from '../client/types';
import type { SourceFile } from '#project/project';

/** Delay between the last change and fetching the work, in ms. Chosen: time to finish a stroke or a line. */
const SETTLED_MS = 500;

/** The initial data that the host gives an element. */
export interface Given {
  /** A project's file as text or value, or its address. */
  readonly project: ProjectFile | string | null;
  readonly scene: SceneFile | string | null;
  readonly files: readonly SourceFile[] | null;
}

/** The work in an element. It survives the element's page, which is lost whenever the element is moved. */
export class Work {
  private latest: ProjectFile | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Sends a page its data: the latest work, otherwise that of the host.
   *
   * @returns whether it sent a project, which has settings of its own
   * @throws ParcoursError, or TypeError if an address cannot be fetched (as a rejection)
   */
  async bring(parcours: Parcours, { project, scene, files }: Given): Promise<boolean> {
    if (this.latest !== null) {
      // A page that keeps work may have it already; opening it again would list it as earlier work.
      const isThere = JSON.stringify(await parcours.getProject()) === JSON.stringify(this.latest);
      if (!isThere) await parcours.setProject(this.latest);
      return !isThere;
    }
    if (project !== null) await parcours.setProject(await projectFile(project));
    if (scene !== null) await parcours.setScene(scene);
    if (files !== null) await parcours.setFiles(files);
    return project !== null;
  }

  /** The user has changed it: fetches it once they pause. */
  changed(parcours: Parcours): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      parcours.getProject().then(
        (project) => (this.latest = project),
        () => undefined, // the page is gone: the last fetched work is the latest
      );
    }, SETTLED_MS);
  }

  /** Forgets the work: the host's data count again. */
  forget(): void {
    clearTimeout(this.timer);
    this.latest = null;
  }
}

/** The file at an address; a text that is not an address is the file itself. */
export async function projectFile(given: ProjectFile | string): Promise<ProjectFile | string> {
  if (typeof given !== 'string' || given.trimStart().startsWith('{')) return given;
  const answer = await fetch(new URL(given, document.baseURI));
  if (!answer.ok) throw new TypeError(`The project ${given} cannot be fetched: ${answer.status}.`);
  return answer.text();
}
