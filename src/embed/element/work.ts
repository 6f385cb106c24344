import type { Parcours, ProjectFile, SceneFile } from '../client/types';
import type { SourceFile } from '#project/project';

/** How long after the last change the work is fetched, in ms. Chosen: a stroke is drawn, a line is typed. */
const SETTLED_MS = 500;

/** What the host gives an element to begin with. */
export interface Given {
  /** A project's file as text or value, or its address. */
  readonly project: ProjectFile | string | null;
  readonly scene: SceneFile | string | null;
  readonly files: readonly SourceFile[] | null;
}

/** What is worked on in an element: it outlives the element's page, which is gone whenever the element is moved. */
export class Work {
  private latest: ProjectFile | null = null;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /**
   * Brings a page what it should have: the latest work, else what the host gives.
   *
   * @returns whether a project came, which has settings of its own
   * @throws ParcoursError, or TypeError when an address cannot be fetched (as a rejection)
   */
  async bring(parcours: Parcours, { project, scene, files }: Given): Promise<boolean> {
    if (this.latest !== null) {
      // A page that keeps work may have it already; what is opened again would be listed as earlier work.
      const isThere = JSON.stringify(await parcours.getProject()) === JSON.stringify(this.latest);
      if (!isThere) await parcours.setProject(this.latest);
      return !isThere;
    }
    if (project !== null) await parcours.setProject(await projectFile(project));
    if (scene !== null) await parcours.setScene(scene);
    if (files !== null) await parcours.setFiles(files);
    return project !== null;
  }

  /** Somebody has changed it: fetches it once they have paused. */
  changed(parcours: Parcours): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => {
      parcours.getProject().then(
        (project) => (this.latest = project),
        () => undefined, // the page is gone: what was fetched before is the latest
      );
    }, SETTLED_MS);
  }

  /** Nothing was worked on: what the host gives counts again. */
  forget(): void {
    clearTimeout(this.timer);
    this.latest = null;
  }
}

/** The file behind an address; a text that is no address is the file itself. */
export async function projectFile(given: ProjectFile | string): Promise<ProjectFile | string> {
  if (typeof given !== 'string' || given.trimStart().startsWith('{')) return given;
  const answer = await fetch(new URL(given, document.baseURI));
  if (!answer.ok) throw new TypeError(`The project ${given} cannot be fetched: ${answer.status}.`);
  return answer.text();
}
