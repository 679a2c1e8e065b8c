// Particles as spots of light that saturate towards white, as in the frames: c becomes 1 - (1 - c) exp(-light).
import * as THREE from 'three';

const BRIGHTNESS = 0.45;

/** Of instances of a square from -1 to 1, which turns to the camera. */
export function glow() {
  const material = new THREE.MeshBasicMaterial({transparent: true, depthWrite: false, blending: THREE.CustomBlending,
    blendSrc: THREE.OneMinusDstColorFactor, blendDst: THREE.OneFactor});
  material.onBeforeCompile = shader => {
    shader.vertexShader = 'varying vec2 spot;\n' + shader.vertexShader.replace('#include <project_vertex>', `
        spot = position.xy;
        vec4 mvPosition = viewMatrix * instanceMatrix * vec4(0.0, 0.0, 0.0, 1.0);
        mvPosition.xy += instanceMatrix[0][0] * spot;
        gl_Position = projectionMatrix * mvPosition;`);
    shader.fragmentShader = 'varying vec2 spot;\n' + shader.fragmentShader.replace('#include <colorspace_fragment>', `
        #include <colorspace_fragment>
        float share = max(0.0, 1.0 - dot(spot, spot));
        gl_FragColor.rgb = 1.0 - exp(-${BRIGHTNESS} * share * share * gl_FragColor.rgb);`);
  };
  return material;
}
