import type { SourceFile } from '#project/project';

import type { ParcoursError } from '../client/parcours-error';
import type { ClientEvents, Parcours, ProjectFile, SceneFile, Welcome } from '../client/types';
import { pageAddress } from './address';
import { attributeProblem, CHECKED, wrongAttribute } from './attribute-problem';
import { ParcoursAttributes, takeEarlyProperties } from './attributes';
import { PageFrame } from './page-frame';
import { ABOVE_PROJECT, snapshotHzOf, wishes } from './wishes';
import { projectFile, Work, type Given } from './work';

/** The element's events by name, with their `detail`. */
export interface ParcoursSimulatorEvents {
  /** The page is ready and has the element's data. */
  readonly 'parcours-ready': Welcome;
  /** The page does not answer, or refuses an attribute or a property: usually a `ParcoursError`. */
  readonly 'parcours-error': unknown;
  /** The page was loaded anew and has the latest work again. */
  readonly 'parcours-restarted': Welcome;
  readonly phase: ClientEvents['phase'];
  readonly started: ClientEvents['started'];
  readonly programrestart: ClientEvents['program-restarted'];
  readonly ended: ClientEvents['ended'];
  readonly output: ClientEvents['output'];
  readonly snapshot: ClientEvents['snapshot'];
  readonly held: ClientEvents['held'];
  readonly looking: ClientEvents['looking'];
  readonly breakpointschange: ClientEvents['break-points-changed'];
  readonly scenechange: ClientEvents['scene-changed'];
  readonly fileschange: ClientEvents['files-changed'];
  readonly settingschange: ClientEvents['settings-changed'];
  readonly sensed: ClientEvents['sensed'];
  readonly radio: ClientEvents['radio'];
  readonly log: ClientEvents['log'];
  readonly refused: ClientEvents['refused'];
  readonly failed: ClientEvents['failed'];
}

type OtherEvents = Exclude<keyof HTMLElementEventMap, keyof ParcoursSimulatorEvents>;

/** A new value of these means another page: the frame is loaded anew. */
const LOADED_ANEW: readonly string[] = ['src', 'world', 'task', 'sandboxed'];
/** As wide as there is room: with only a height set, the ratio would make it wider than that. */
const STYLE =
  ':host{display:block;box-sizing:border-box;position:relative;width:100%;aspect-ratio:16/10}' +
  ':host{min-width:200px;min-height:160px}' +
  ':host([hidden]){display:none}' +
  'iframe{position:absolute;inset:0;width:100%;height:100%;border:0}';
/** The page may make sound, go full screen and put programs on a real board if this page may. */
const ALLOW = 'usb; serial; autoplay; fullscreen; clipboard-write';
/** Begins to load a little before it is scrolled into view. */
const NEAR = '200px';

/**
 * `<parcours-simulator>`: Parcours as an element of any page. Attributes say what it shows, methods command it, events
 * report from it. The work in it stays when the element is moved.
 */
export class ParcoursSimulatorElement extends ParcoursAttributes {
  static readonly observedAttributes: readonly string[] = [
    ...[...Object.keys(wishes), ...LOADED_ANEW],
    ...['project', 'loading', 'title', 'aria-label', 'allow'],
  ];
  private readonly inside: ShadowRoot;
  private readonly work = new Work();
  /** Data that the host has set by script. */
  private given: Given = { project: null, scene: null, files: null };
  private page: PageFrame | null = null;
  /** The client of the page, once it is ready and has everything. */
  private client: Parcours | null = null;
  private promised: Promised | null = null;
  /** The page did not answer: callers get that error until another page is loaded. */
  private isMissing = false;
  private watch: IntersectionObserver | null = null;
  private isAnewPlanned = false;
  /** The values of the `LOADED_ANEW` attributes with which the frame was loaded. */
  private shown = '';
  /** The wrong address that was reported last. */
  private wrongAddress: string | null = null;
  /** Attributes that have changed since the frame got its address. */
  private readonly changed = new Set<string>();

  constructor() {
    super();
    this.inside = this.attachShadow({ mode: 'open', delegatesFocus: true });
    const style = new CSSStyleSheet();
    style.replaceSync(STYLE);
    this.inside.adoptedStyleSheets = [style];
    takeEarlyProperties(this);
  }

  /** The frame that is shown, or `null`. */
  get frame(): HTMLIFrameElement | null {
    return this.page?.frame ?? null;
  }

  /** The initial project: its file as text or value, or its address. As an attribute: its address. */
  get project(): ProjectFile | string | null {
    return this.given.project ?? this.getAttribute('project');
  }
  set project(project: ProjectFile | string | null) {
    this.give({ project });
    if (project !== null) this.bring(async (it) => it.setProject(await projectFile(project)));
  }

  /** The initial course, instead of the project's. */
  get scene(): SceneFile | string | null {
    return this.given.scene;
  }
  set scene(scene: SceneFile | string | null) {
    this.give({ scene });
    if (scene !== null) this.bring((it) => it.setScene(scene));
  }

  /** The initial program, instead of the project's. */
  get files(): readonly SourceFile[] | null {
    return this.given.files;
  }
  set files(files: readonly SourceFile[] | null) {
    this.give({ files });
    if (files !== null) this.bring((it) => it.setFiles(files));
  }

  override whenReady(): Promise<Parcours> {
    this.promised ??= promise();
    const { result } = this.promised;
    this.open();
    return result;
  }

  override addEventListener<E extends keyof ParcoursSimulatorEvents>(
    type: E,
    listener: (this: ParcoursSimulatorElement, event: CustomEvent<ParcoursSimulatorEvents[E]>) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener<E extends OtherEvents>(
    type: E,
    listener: (this: HTMLElement, event: HTMLElementEventMap[E]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
  override addEventListener(type: string, listener: unknown, options?: boolean | AddEventListenerOptions): void {
    super.addEventListener(type, listener as EventListenerOrEventListenerObject, options);
  }

  override focus(options?: FocusOptions): void {
    this.page?.frame.focus(options);
  }

  connectedCallback(): void {
    this.openWhenSeen();
  }

  /** Moved by a browser that can do so without reloading the frame: everything goes on. */
  connectedMoveCallback(): void {
    return undefined;
  }

  disconnectedCallback(): void {
    this.close();
  }

  attributeChangedCallback(name: string, before: string | null, after: string | null): void {
    if (before === after) return;
    if (LOADED_ANEW.includes(name)) this.planAnew();
    else if (name === 'project') this.project = after;
    else if (name === 'loading') this.changeLoading();
    else if (this.page !== null && name === 'allow') this.page.frame.allow = after ?? ALLOW;
    else if (this.page !== null && !(name in wishes)) this.page.frame.title = this.frameTitle();
    else if (this.page !== null) {
      this.changed.add(name);
      this.bring((it) => this.wish(it, name));
    }
  }

  /** Loads the page if necessary, as soon as the element is in a page and has an address. */
  private open(): void {
    if (this.page !== null || !this.isConnected) return;
    const address = pageAddress((name) => this.pageAttribute(name), document.baseURI);
    if (address === null) return this.complainOfAddress();
    this.stopWatching();
    const page = new PageFrame({
      address,
      title: this.frameTitle(),
      allow: this.getAttribute('allow') ?? ALLOW,
      isSandboxed: this.sandboxed,
      subscribe: { snapshotHz: snapshotHzOf(this.snapshotHz) },
      tell: (event, detail) => void this.hear(event, detail),
    });
    this.page = page;
    this.shown = this.wanted();
    this.changed.clear();
    this.promised ??= promise();
    this.inside.replaceChildren(page.frame);
    this.connect(page).catch((error: unknown) => {
      if (this.page !== page) return;
      this.isMissing = true;
      this.promised?.fail(error);
      this.tell('parcours-error', error);
    });
  }

  private async connect(page: PageFrame): Promise<void> {
    const parcours = await page.connect();
    if (parcours === null) return;
    await this.bringEverything(parcours);
    if (this.page !== page) return;
    this.client = parcours;
    this.promised?.keep(parcours);
    this.tell('parcours-ready', parcours.welcome);
  }

  /** Sends the work, and settings that the address does not carry. A refusal is reported and stops nothing else. */
  private async bringEverything(parcours: Parcours): Promise<void> {
    const complain = (error: unknown): void => this.tell('parcours-error', error);
    const isProject = await this.work.bring(parcours, { ...this.given, project: this.project }).catch(complain);
    const said = ABOVE_PROJECT.filter((name) => isProject === true && this.hasAttribute(name));
    const wished = new Set([...said, ...this.changed]);
    for (const name of wished) await this.wish(parcours, name).catch(complain);
    // The others are in the address, whose wrong values the page takes as left out.
    for (const problem of CHECKED.filter((name) => !wished.has(name)).map((name) => this.problemOf(parcours, name)))
      if (problem !== null) complain(problem);
  }

  private async hear(event: string, detail: unknown): Promise<void> {
    const { client } = this;
    if (event === 'parcours-restarted' && client !== null) await this.bringEverything(client);
    else if (client !== null && /^(files|scene|settings)change$/.test(event)) this.work.changed(client);
    this.tell(event, detail);
  }

  private close(): void {
    this.stopWatching();
    const { page } = this;
    this.page = null;
    // Callers who wait for a page go on waiting for the next one.
    if (this.client !== null || this.isMissing) this.promised = null;
    this.client = null;
    this.isMissing = false;
    page?.close();
  }

  /** Several attributes often change together, and at the element's start: the page is loaded once. */
  private planAnew(): void {
    if (this.isAnewPlanned || !this.isConnected) return;
    this.isAnewPlanned = true;
    queueMicrotask(() => {
      this.isAnewPlanned = false;
      if (this.page !== null && this.shown === this.wanted()) return;
      this.work.forget();
      this.close();
      this.openWhenSeen();
    });
  }

  private wanted(): string {
    return LOADED_ANEW.map((name) => this.getAttribute(name)).join('\n');
  }

  private openWhenSeen(): void {
    this.stopWatching();
    if (!this.isConnected || this.page !== null) return;
    if (this.loading === 'eager' || this.promised !== null) {
      this.open();
      return;
    }
    this.watch = new IntersectionObserver((seen) => seen.some((it) => it.isIntersecting) && this.open(), { rootMargin: NEAR }); // prettier-ignore
    this.watch.observe(this);
  }

  private stopWatching(): void {
    this.watch?.disconnect();
    this.watch = null;
  }

  private give(given: Partial<Given>): void {
    this.given = { ...this.given, ...given };
    this.work.forget();
  }

  /** Does something to the page if it is ready; otherwise the page gets it later with everything else. */
  private bring(act: (parcours: Parcours) => Promise<void>): void {
    const { client } = this;
    if (client === null) return;
    act(client).catch((error: unknown) => {
      // A page that was closed meanwhile has nothing to say: the next one gets it with everything else.
      if (this.client === client) this.tell('parcours-error', error);
    });
  }

  /** @throws ParcoursError (as a rejection) for a value that makes no sense: it counts as left out */
  private async wish(parcours: Parcours, name: string): Promise<void> {
    const problem = this.problemOf(parcours, name);
    const isRefused = problem !== null && ABOVE_PROJECT.includes(name);
    await wishes[name]?.(parcours, isRefused ? null : this.pageAttribute(name));
    if (problem !== null) throw problem;
  }

  /** The fault of the element's own attribute; the surrounding text is not checked. */
  private problemOf(parcours: Parcours, name: string): ParcoursError | null {
    return attributeProblem(name, this.getAttribute(name), parcours.welcome.abilities);
  }

  private changeLoading(): void {
    this.openWhenSeen();
    this.bring((it) => this.wish(it, 'loading'));
  }

  /** Reports a wrong address once; without an address there is nothing to show yet. */
  private complainOfAddress(): void {
    const { src } = this;
    if (src === null || src === '' || src === this.wrongAddress) return;
    this.wrongAddress = src;
    this.tell('parcours-error', wrongAttribute('src', `${JSON.stringify(src)} is not the address of a page.`));
  }

  /** The effective value of an attribute: the language defaults to that of the surrounding text. */
  private pageAttribute(name: string): string | null {
    return name === 'lang' ? (this.closest('[lang]')?.getAttribute('lang') ?? null) : this.getAttribute(name);
  }

  private frameTitle(): string {
    return this.getAttribute('aria-label') ?? this.getAttribute('title') ?? 'Parcours';
  }

  private tell(event: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(event, { detail }));
  }
}

interface Promised {
  readonly result: Promise<Parcours>;
  readonly keep: (parcours: Parcours) => void;
  readonly fail: (reason: unknown) => void;
}

/** The promise of a page. Its rejection needs no handler, because there is also an event for it. */
function promise(): Promised {
  let keep: Promised['keep'] = () => undefined;
  let fail: Promised['fail'] = () => undefined;
  const result = new Promise<Parcours>((kept, failed) => {
    keep = kept;
    fail = failed;
  });
  result.catch(() => undefined);
  return { result, keep, fail };
}
