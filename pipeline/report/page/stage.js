// What is drawn with WebGL: renderer, lights, materials, and the colours of the theme.
import { colour } from "./colours.js";
import { build } from "./elements.js";
import { createMaterials } from "./materials.js";
import { boneGeometry } from "./shapes.js";

// True if WebGL is drawn by the processor, which is too slow for smooth edges.
function isSoftwareRenderer() {
  const context = build("canvas").getContext("webgl");
  const info = context?.getExtension("WEBGL_debug_renderer_info");
  const name = info ? context.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

function createRenderer(canvas) {
  try {
    return new THREE.WebGLRenderer({ canvas, antialias: !isSoftwareRenderer() });
  } catch {
    return null;
  }
}

// {root, materials, renderer, render(camera), theme(), compile(camera)}; null without WebGL.
export function createStage(canvas) {
  const renderer = createRenderer(canvas);
  if (!renderer) return null;
  const root = new THREE.Scene();
  const { materials, applyTheme } = createMaterials();
  // From above and beside the camera, so that what is seen is lit.
  const directionalLight = new THREE.DirectionalLight(0xffffff, 0.55);
  const ambientLight = new THREE.HemisphereLight(0xffffff, 0xb4b4ba, 0.68);
  ambientLight.position.set(0, 0, 1);
  root.add(directionalLight, ambientLight);
  const theme = () => {
    applyTheme();
    root.background = new THREE.Color(colour("--scene-ground"));
  };
  theme();
  return {
    root, materials, renderer, theme,
    render(camera) {
      directionalLight.position.set(-0.7, 0.9, 1).transformDirection(camera.matrixWorld);
      renderer.render(root, camera);
    },
    // Compiles the shaders of all materials, before the first movement is opened.
    compile(camera) {
      const samples = new THREE.Group();
      for (const material of Object.values(materials)) {
        const part = material.isLineBasicMaterial ? THREE.LineSegments : THREE.Mesh;
        samples.add(new part(boneGeometry(), material));
      }
      root.add(samples);
      renderer.compile(root, camera);
      root.remove(samples);
    },
  };
}
