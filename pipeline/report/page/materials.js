// The materials of the 3D view, in the colours of the theme.
import { colour } from "./colours.js";
import { stripes } from "./shapes.js";

export const kRobotColours = 4;
const kHandLighter = 0.4; // than the arm, so that one is told from the other

// Materials by name; applyTheme() gives them the theme's colours.
export function createMaterials() {
  const solid = (more = {}) => new THREE.MeshLambertMaterial(more);
  const line = (more = {}) => new THREE.LineBasicMaterial(more);
  const faint = { transparent: true, opacity: 0.2, depthWrite: false };
  const materials = {
    person: solid(), torso: solid({ transparent: true, opacity: 0.32, depthWrite: false }), goal: solid(), goalLine: new THREE.LineDashedMaterial({ dashSize: 0.012, gapSize: 0.008 }),
    tipLine: line(), gap: solid(), reach: line(), object: solid(), target: solid(), obstacle: solid(), edge: line(),
    hiddenEdge: line({ transparent: true, opacity: 0.55, depthTest: false }),
    floor: line({ transparent: true, opacity: 0.4 }),
    near: solid(), picked: solid(), touching: solid(), touchingObject: solid(), mappedPath: solid(faint),
    nearest: new THREE.MeshBasicMaterial({ depthTest: false }), invisible: new THREE.MeshBasicMaterial({ visible: false }),
    ...Object.fromEntries(Array.from({ length: kRobotColours }, (_, k) => [[`robot-${k}`, solid()], [`hand-${k}`, solid()]]).flat()),
    tip: solid(), mesh: solid(), contact: new THREE.MeshBasicMaterial({ depthTest: false }),
  };
  const names = { person: "--person", torso: "--person", goal: "--goal", goalLine: "--goal", tipLine: "--robot-0", gap: "--bad",
    reach: "--bad", object: "--object", target: "--target", obstacle: "--obstacle", hiddenEdge: "--obstacle",
    edge: "--scene-line", floor: "--scene-line", near: "--near",
    picked: "--accent", mappedPath: "--mapped", nearest: "--near", tip: "--robot-0", mesh: "--mesh", contact: "--accent" };
  const applyTheme = () => {
    for (const [kind, name] of Object.entries(names)) materials[kind].color.set(colour(name));
    for (let k = 0; k < kRobotColours; ++k) {
      materials[`robot-${k}`].color.set(colour(`--robot-${k}`));
      materials[`hand-${k}`].color.copy(materials[`robot-${k}`].color).lerp(new THREE.Color("white"), kHandLighter);
    }
    materials.touching.map = stripes(colour("--bad"), colour("--near"));
    materials.touchingObject.map = stripes(colour("--bad"), colour("--target"));
  };
  applyTheme();
  return { materials, applyTheme };
}
