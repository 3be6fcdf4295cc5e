// SPDX-License-Identifier: MIT
// Copyright (c) 2026 the qmesh authors
//
// The preview page of a quantized-mesh set: the terrain of the layer.json beside it, coloured by height and
// lit, without imagery and without an account anywhere.
//
// Tests use `window.qmesh`: `ready` settles when the terrain is on the globe and the camera is placed, or
// fails with the reason the page shows; `viewer` is the CesiumJS viewer from then on.
"use strict";
{
  const cesiumBase = new URL(document.currentScript.dataset.cesium, document.baseURI).href;
  const setUrl = new URL(".", document.baseURI).href;
  const { boundsOf, formatHeight, heightRange, lightFromUpperLeft, lookAt, showLegend, terrainMaterial } =
    terrainLook;
  const byId = (id) => document.getElementById(id);

  const MAX_EXAGGERATION = 20;

  // ---- Messages -------------------------------------------------------------------------------

  /** A failure the user can do something about: a heading, sentences, and commands to copy. */
  class Trouble extends Error {
    constructor(heading, ...lines) {
      super(heading + " " + lines.map((line) => line.command ?? line).join(" "));
      this.heading = heading;
      this.lines = lines;
    }
  }

  function showMessage(heading, lines) {
    const title = document.createElement("h2");
    title.textContent = heading;
    const parts = lines.map((line) => {
      const part = document.createElement(line.command ? "pre" : "p");
      part.textContent = line.command ?? line;
      return part;
    });
    byId("message").replaceChildren(title, ...parts);
  }

  function hideMessage() {
    byId("message").replaceChildren();
  }

  /** The folder of this page as the file system names it; for pages opened with file://. */
  function folderOnDisk() {
    const folder = decodeURIComponent(new URL(setUrl).pathname).replace(/(.)\/$/, "$1");
    return /^\/[A-Za-z]:/.test(folder) ? folder.slice(1) : folder;
  }

  /** An argument in quotes where a shell would split or expand it. */
  function quoted(argument) {
    return /^[\w@%+=:,./-]+$/.test(argument) ? argument : `'${argument.replaceAll("'", "'\\''")}'`;
  }

  function requireServer() {
    if (location.protocol !== "file:") return;
    throw new Trouble(
      "This page needs a web server.",
      "Browsers do not let a page opened from disk read the tiles beside it. Start a server in a terminal:",
      { command: `python3 -m http.server 8000 --directory ${quoted(folderOnDisk())}` },
      "and open this address:", { command: "http://localhost:8000/" });
  }

  // ---- Loading --------------------------------------------------------------------------------

  function loadCesium() {
    showMessage("Loading CesiumJS …", [`from ${cesiumBase}`]);
    window.CESIUM_BASE_URL = cesiumBase;
    return new Promise((resolve, reject) => {
      const script = document.createElement("script");
      script.src = cesiumBase + "Cesium.js";
      script.onload = resolve;
      script.onerror = () => reject(new Trouble(
        "CesiumJS could not be loaded.",
        `This page draws the terrain with CesiumJS from ${cesiumBase}, which did not answer. Check that ` +
        "this computer is online, or put a copy of CesiumJS beside the page: get a release of it " +
        "(folder Build/Cesium) and run",
        { command: "gdal2qmesh -w cesium --cesium Build/Cesium --overwrite INPUT OUTPUT" }));
      document.head.append(script);
    });
  }

  /** Unpacks gzip data; anything else comes back as it is. */
  async function unpacked(buffer) {
    const start = new Uint8Array(buffer, 0, Math.min(2, buffer.byteLength));
    if (start[0] !== 0x1f || start[1] !== 0x8b) return buffer;
    const stream = new Blob([buffer]).stream().pipeThrough(new DecompressionStream("gzip"));
    return new Response(stream).arrayBuffer();
  }

  /** Plain servers send gzip tiles without saying so, and CesiumJS then meets the packed bytes. */
  function unpackTilesInThePage() {
    const fetchArrayBuffer = Cesium.Resource.prototype.fetchArrayBuffer;
    Cesium.Resource.prototype.fetchArrayBuffer = function () {
      // Undefined means that CesiumJS put the request off.
      return fetchArrayBuffer.call(this)?.then(unpacked);
    };
  }

  async function readLayer() {
    const response = await fetch(new URL("layer.json", setUrl)).catch(() => undefined);
    if (!response?.ok) {
      throw new Trouble("There is no layer.json beside this page.",
        "It is written when a set is complete. Let gdal2qmesh finish, or run it again.");
    }
    const layer = await response.json();
    if (!layer.available?.[0]?.length) {
      throw new Trouble("This set has no level 0.",
        "CesiumJS starts there and cannot draw the set alone. Build it from zoom 0, for example:",
        { command: `gdal2qmesh -z 0-${layer.maxzoom ?? ""} -w cesium --overwrite INPUT OUTPUT` });
    }
    return layer;
  }

  /** Sets whose tiles list their descendants name only the first levels in `available`. */
  function deepestLevel(layer) {
    return layer.maxzoom ?? layer.available.length - 1;
  }

  function makeViewer() {
    Cesium.Ion.defaultAccessToken = undefined;
    let viewer;
    try {
      viewer = new Cesium.Viewer("globe", {
        baseLayer: false, baseLayerPicker: false, geocoder: false, animation: false, timeline: false,
        homeButton: false, sceneModePicker: false, navigationHelpButton: false, fullscreenButton: false,
        infoBox: false, selectionIndicator: false, skyBox: false, skyAtmosphere: false,
        requestRenderMode: true, maximumRenderTimeChange: Infinity, showRenderLoopErrors: false,
        // Without multisampling: it lets the skirts, coloured by their depth, shine through at tile edges.
        msaaSamples: 1,
      });
    } catch (error) {
      throw new Trouble("This browser cannot draw in 3D.",
        "WebGL 2 is missing or switched off. " + (error.message ?? ""));
    }
    const { scene } = viewer;
    scene.backgroundColor = Cesium.Color.fromCssColorString("#12161a");
    scene.fog.enabled = false;
    scene.globe.showGroundAtmosphere = false;
    scene.globe.baseColor = Cesium.Color.fromCssColorString("#8a8f94");
    scene.globe.enableLighting = true;
    scene.globe.lambertDiffuseMultiplier = 0.85;
    scene.globe.vertexShadowDarkness = 0.27;
    scene.screenSpaceCameraController.enableCollisionDetection = true;
    return viewer;
  }

  // ---- Read-outs ------------------------------------------------------------------------------

  function formatAngle(radians, positive, negative) {
    const degrees = Cesium.Math.toDegrees(radians);
    return `${Math.abs(degrees).toFixed(5)}° ${degrees < 0 ? negative : positive}`;
  }

  /** The tiles of the last frame. CesiumJS has no public name for them; the version is pinned. */
  function tilesDrawn(viewer) {
    return viewer.scene.globe._surface?._tilesToRender ?? [];
  }

  /**
   * The height of a tile's terrain at a place, undefined beside it. Not the height of the surface drawn: at
   * low levels its flat triangles lie kilometres below the curved Earth.
   */
  function heightOnMesh({ encoding, vertices, indices, indexCountWithoutSkirts }, rectangle, place) {
    const u = (place.longitude - rectangle.west) / rectangle.width;
    const v = (place.latitude - rectangle.south) / rectangle.height;
    const corners = [0, 1, 2].map(() => new Cesium.Cartesian2());
    for (let at = 0; at < indexCountWithoutSkirts; at += 3) {
      const [a, b, c] = corners.map((corner, k) =>
        encoding.decodeTextureCoordinates(vertices, indices[at + k], corner));
      const whole = (b.x - a.x) * (c.y - a.y) - (c.x - a.x) * (b.y - a.y);
      const atB = ((u - a.x) * (c.y - a.y) - (c.x - a.x) * (v - a.y)) / whole;
      const atC = ((b.x - a.x) * (v - a.y) - (u - a.x) * (b.y - a.y)) / whole;
      if (!(atB >= -1e-6 && atC >= -1e-6 && atB + atC <= 1 + 1e-6)) continue;
      const height = (k) => encoding.decodeHeight(vertices, indices[at + k]);
      return (1 - atB - atC) * height(0) + atB * height(1) + atC * height(2);
    }
    return undefined;
  }

  /** The level a tile's heights come from: where a set ends, CesiumJS cuts deeper tiles out of its last ones. */
  function levelOf(tile, place, viewer) {
    const deepest = viewer.terrainProvider.availability?.computeMaximumLevelAtPosition(place);
    return Math.min(tile.level, deepest ?? tile.level);
  }

  function plural(count, word) {
    return `${count.toLocaleString("en").replaceAll(",", "\u202f")} ${word}${count === 1 ? "" : "s"}`;
  }

  function showPlace(viewer, windowPosition) {
    const ray = viewer.camera.getPickRay(windowPosition);
    const hit = ray && viewer.scene.globe.pick(ray, viewer.scene);
    if (!hit) {
      byId("place").textContent = "Point at the terrain to read its height";
      return;
    }
    const place = Cesium.Cartographic.fromCartesian(hit);
    const tile = tilesDrawn(viewer).find((drawn) => Cesium.Rectangle.contains(drawn.rectangle, place));
    const mesh = tile?.data?.renderedMesh;
    const height = (mesh && heightOnMesh(mesh, tile.rectangle, place))
      ?? place.height / viewer.scene.verticalExaggeration;
    byId("place").textContent = [
      formatAngle(place.latitude, "N", "S"), formatAngle(place.longitude, "E", "W"),
      `${formatHeight(height, 1)} m`, ...(tile ? [`level ${levelOf(tile, place, viewer)}`] : []),
    ].join(" · ");
  }

  function showWhatIsDrawn(viewer, failures) {
    const tiles = tilesDrawn(viewer);
    const deepest = tiles.reduce((level, tile) => Math.max(level, tile.level), 0);
    const triangles = tiles.reduce((sum, tile) =>
      sum + (tile.data?.renderedMesh?.indexCountWithoutSkirts ?? 0) / 3, 0);
    const parts = [`levels to ${deepest}`, plural(tiles.length, "tile"), plural(triangles, "triangle")];
    if (failures.length > 0) parts.push(`${plural(failures.length, "tile")} failed: ${failures[0]}`);
    byId("drawn").textContent = parts.join(" · ");
  }

  function followMouse(viewer, failures) {
    let position;
    const handler = new Cesium.ScreenSpaceEventHandler(viewer.scene.canvas);
    const remember = (event) => {
      position = Cesium.Cartesian2.clone(event.endPosition ?? event.position);
      viewer.scene.requestRender();
    };
    handler.setInputAction(remember, Cesium.ScreenSpaceEventType.MOUSE_MOVE);
    handler.setInputAction(remember, Cesium.ScreenSpaceEventType.LEFT_CLICK);
    viewer.scene.postRender.addEventListener(() => {
      if (position) showPlace(viewer, position);
      showWhatIsDrawn(viewer, failures);
    });
    byId("readout").hidden = false;
  }

  // ---- Switches -------------------------------------------------------------------------------

  function exaggerationAt(slider) {
    return Math.round(MAX_EXAGGERATION ** (slider / 100) * 10) / 10;
  }

  function connectSwitches(viewer, material, goHome) {
    const { scene } = viewer;
    const onChange = (id, apply) => byId(id).addEventListener("input", (event) => {
      apply(event.target);
      scene.requestRender();
    });
    onChange("light", (box) => { scene.globe.enableLighting = box.checked; });
    onChange("wireframe", (box) => {
      scene.globe._surface.tileProvider._debug.wireframe = box.checked;
    });
    onChange("borders", (box) => { material.uniforms.borders = box.checked ? 1 : 0; });
    onChange("exaggeration", (slider) => {
      scene.verticalExaggeration = exaggerationAt(slider.valueAsNumber);
      material.uniforms.exaggeration = scene.verticalExaggeration;
      byId("times").textContent = `${scene.verticalExaggeration}×`;
    });
    byId("home").addEventListener("click", goHome);
  }

  function connectKeys(viewer) {
    const click = { l: "light", w: "wireframe", b: "borders", h: "home" };
    const { camera, canvas } = viewer;
    const step = () => Math.min(0.15, (camera.positionCartographic.height / 6.4e6) * 0.15);
    const move = {
      ArrowLeft: () => camera.rotateRight(step()), ArrowRight: () => camera.rotateLeft(step()),
      ArrowUp: () => camera.rotateDown(step()), ArrowDown: () => camera.rotateUp(step()),
      "+": () => camera.moveForward(camera.positionCartographic.height * 0.2),
      "-": () => camera.moveBackward(camera.positionCartographic.height * 0.2),
    };
    canvas.tabIndex = 0;
    canvas.setAttribute("aria-label", "Terrain; arrow keys move, plus and minus zoom");
    canvas.addEventListener("pointerdown", () => canvas.focus({ preventScroll: true }));
    document.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const id = click[event.key.toLowerCase()];
      if (id) byId(id).click();
      if (event.target !== canvas || !move[event.key]) return;
      move[event.key]();
      event.preventDefault();
    });
  }

  function describe(layer, hasNormals) {
    const levels = deepestLevel(layer);
    const parts = [layer.projection ?? "EPSG:4326", levels ? `levels 0 to ${levels}` : "level 0"];
    if (layer.qmesh?.method) parts.push(layer.qmesh.method);
    byId("about").textContent = parts.join(" · ");
    if (hasNormals) return;
    byId("light").checked = false;
    byId("light").disabled = true;
    byId("light").parentElement.classList.add("disabled");
    byId("about").textContent += " · no normals, so the relief cannot be lit";
  }

  // ---- The page -------------------------------------------------------------------------------

  async function start() {
    requireServer();
    await loadCesium();
    unpackTilesInThePage();
    const layer = await readLayer();
    const provider = await Cesium.CesiumTerrainProvider.fromUrl(setUrl, { requestVertexNormals: true });
    const failures = [];
    provider.errorEvent.addEventListener((error) => failures.push(error.message));

    const bounds = boundsOf(layer);
    const range = await heightRange(provider, bounds, deepestLevel(layer));
    const viewer = makeViewer();
    window.qmesh.viewer = viewer;
    const material = terrainMaterial(range, bounds);
    viewer.scene.globe.material = material;
    viewer.terrainProvider = provider;
    viewer.scene.globe.enableLighting = provider.hasVertexNormals;

    const goHome = () => lookAt(viewer, bounds, (range[0] + range[1]) / 2);
    describe(layer, provider.hasVertexNormals);
    showLegend(range);
    lightFromUpperLeft(viewer);
    followMouse(viewer, failures);
    connectSwitches(viewer, material, goHome);
    connectKeys(viewer);
    if (matchMedia("(max-width: 600px)").matches) byId("panel").open = false;
    goHome();
    hideMessage();
  }

  function showTrouble(error) {
    if (error instanceof Trouble) showMessage(error.heading, error.lines);
    else showMessage("The terrain cannot be shown.", [String(error?.message ?? error)]);
  }

  window.qmesh = { ready: start() };
  window.qmesh.ready.catch(showTrouble);
}
