import type { Parcours } from '../client/types';

/** The class of all elements; outside a browser, where the element can be imported but has no effect, an empty one. */
const Base: typeof HTMLElement = 'HTMLElement' in globalThis ? HTMLElement : (class {} as typeof HTMLElement);

/** The client's methods on an element: each waits until the page has answered. */
export abstract class ParcoursMethods extends Base {
  /** The client of the page, once the page has answered and has the element's data; loads the page if necessary. */
  abstract whenReady(): Promise<Parcours>;

  readonly setProject: Parcours['setProject'] = (project) => this.whenThere((it) => it.setProject(project));
  readonly getProject: Parcours['getProject'] = () => this.whenThere((it) => it.getProject());
  readonly setFiles: Parcours['setFiles'] = (files, device) => this.whenThere((it) => it.setFiles(files, device));
  readonly getFiles: Parcours['getFiles'] = (device) => this.whenThere((it) => it.getFiles(device));
  readonly setScene: Parcours['setScene'] = (scene) => this.whenThere((it) => it.setScene(scene));
  readonly getScene: Parcours['getScene'] = () => this.whenThere((it) => it.getScene());
  readonly edit: Parcours['edit'] = (edit) => this.whenThere((it) => it.edit(edit));
  readonly setRobot: Parcours['setRobot'] = (choice) => this.whenThere((it) => it.setRobot(choice));
  readonly getRobot: Parcours['getRobot'] = () => this.whenThere((it) => it.getRobot());
  readonly setSettings: Parcours['setSettings'] = (settings) => this.whenThere((it) => it.setSettings(settings));
  readonly getSettings: Parcours['getSettings'] = () => this.whenThere((it) => it.getSettings());
  readonly setMode: Parcours['setMode'] = (mode) => this.whenThere((it) => it.setMode(mode));

  readonly run: Parcours['run'] = (options = {}) => this.whenThere((it) => it.run(options));
  readonly stop: Parcours['stop'] = () => this.whenThere((it) => it.stop());
  readonly reset: Parcours['reset'] = () => this.whenThere((it) => it.reset());
  readonly pause: Parcours['pause'] = () => this.whenThere((it) => it.pause());
  readonly resume: Parcours['resume'] = () => this.whenThere((it) => it.resume());
  readonly step: Parcours['step'] = () => this.whenThere((it) => it.step());

  readonly getPosition: Parcours['getPosition'] = (device) => this.whenThere((it) => it.getPosition(device));
  readonly setBreakPoints: Parcours['setBreakPoints'] = (points, device) =>
    this.whenThere((it) => it.setBreakPoints(points, device));
  readonly getBreakPoints: Parcours['getBreakPoints'] = (device) => this.whenThere((it) => it.getBreakPoints(device));
  readonly stepLine: Parcours['stepLine'] = (step, device) => this.whenThere((it) => it.stepLine(step, device));
  readonly runTo: Parcours['runTo'] = (place, device) => this.whenThere((it) => it.runTo(place, device));
  readonly lookAt: Parcours['lookAt'] = (atMs) => this.whenThere((it) => it.lookAt(atMs));
  readonly lookNow: Parcours['lookNow'] = () => this.whenThere((it) => it.lookNow());
  readonly goOn: Parcours['goOn'] = (options = {}) => this.whenThere((it) => it.goOn(options));

  readonly place: Parcours['place'] = (pose, device) => this.whenThere((it) => it.place(pose, device));
  readonly placeBlock: Parcours['placeBlock'] = (block, pose) => this.whenThere((it) => it.placeBlock(block, pose));
  readonly press: Parcours['press'] = (button, down, device) => this.whenThere((it) => it.press(button, down, device));
  readonly touch: Parcours['touch'] = (pad, down, device) => this.whenThere((it) => it.touch(pad, down, device));
  readonly setSensor: Parcours['setSensor'] = (sensor, value, device) =>
    this.whenThere((it) => it.setSensor(sensor, value, device));
  readonly setArenaSenses: Parcours['setArenaSenses'] = (on) => this.whenThere((it) => it.setArenaSenses(on));
  readonly serial: Parcours['serial'] = (text, device) => this.whenThere((it) => it.serial(text, device));
  readonly interrupt: Parcours['interrupt'] = (device) => this.whenThere((it) => it.interrupt(device));
  readonly radio: Parcours['radio'] = (packet, device) => this.whenThere((it) => it.radio(packet, device));
  readonly clearConsole: Parcours['clearConsole'] = () => this.whenThere((it) => it.clearConsole());
  readonly getState: Parcours['getState'] = () => this.whenThere((it) => it.getState());
  readonly subscribe: Parcours['subscribe'] = (wish) => this.whenThere((it) => it.subscribe(wish));

  private async whenThere<T>(act: (parcours: Parcours) => Promise<T>): Promise<T> {
    return act(await this.whenReady());
  }
}
