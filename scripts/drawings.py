"""Drawings by other people's tools, one command of trimalla each: ezdxf, shapely, pyshp, laspy, matplotlib, fontTools.

    pip install ezdxf shapely pyshp laspy matplotlib fonttools
    python3 scripts/drawings.py FOLDER [trimalla]

Writes twenty drawings in eight formats into FOLDER. With a program given, meshes each of them with one command, checks
the mesh against its drawing, and prints a line for each. Fails where a command does.
"""
import json, math, random, subprocess, sys
from pathlib import Path
out = Path(sys.argv[1]); out.mkdir(exist_ok=True, parents=True)
random.seed(1)
import ezdxf
from ezdxf.math import BSpline
# 1 plate with holes, units, layers
d = ezdxf.new("R2010", setup=True); d.units = ezdxf.units.MM; m = d.modelspace()
d.layers.add("PLATE"); d.layers.add("HOLES"); d.layers.add("NOTES")
m.add_lwpolyline([(0,0),(200,0,0,0,math.tan(math.pi/8)),(220,20),(220,120),(0,120)], close=True, dxfattribs={"layer":"PLATE"}, format="xyseb")
for x in (30,110,190): m.add_circle((x,60),12,dxfattribs={"layer":"HOLES"})
m.add_text("PLATE 7", dxfattribs={"layer":"NOTES"}).set_placement((5,130))
m.add_linear_dim(base=(0,-20),p1=(0,0),p2=(200,0)).render()
d.saveas(out/"plate.dxf")
# 2 slot of lines and arcs that meet by computed ends
d = ezdxf.new("R12"); m = d.modelspace()
m.add_line((0.1,0.3),(10.1,0.3)); m.add_line((0.1,5.3),(10.1,5.3)); m.add_arc((10.1,2.8),2.5,270,90); m.add_arc((0.1,2.8),2.5,90,270)
m.add_circle((5,2.8),1); d.saveas(out/"slot.dxf")
# 3 spline outline, ellipse hole
d = ezdxf.new("R2018"); m = d.modelspace()
s = m.add_spline(degree=3); s.set_closed([(x,y,0) for x,y in [(0,0),(40,-10),(80,5),(90,50),(50,70),(10,55),(-10,25)]])
m.add_ellipse((40,30),(18,6),0.5); m.add_ellipse((40,30),(4,0),1.0)
d.saveas(out/"blob.dxf")
# 4 blocks, nested and turned
d = ezdxf.new("R2010"); b = d.blocks.new("BOLT"); b.add_circle((0,0),1)
c = d.blocks.new("PAIR"); c.add_blockref("BOLT",(-3,0)); c.add_blockref("BOLT",(3,0),dxfattribs={"xscale":1.5,"yscale":1.5})
m = d.modelspace(); m.add_lwpolyline([(-20,-20),(60,-20),(60,40),(-20,40)],close=True)
for i in range(3): m.add_blockref("PAIR",(i*20,10),dxfattribs={"rotation":30*i})
m.add_blockref("BOLT",(0,-10),dxfattribs={"column_count":4,"column_spacing":12,"row_count":1})
d.saveas(out/"bolts.dxf")
# 5 floor plan of lines with T-joints and a column
d = ezdxf.new("R2000"); m = d.modelspace(); 
for a,b in [((0,0),(8,0)),((8,0),(8,6)),((8,6),(0,6)),((0,6),(0,0)),((3,0),(3,6)),((3,2.5),(8,2.5)),((5.5,2.5),(5.5,6))]: m.add_line(a,b,dxfattribs={"layer":"WALLS"})
m.add_circle((1.5,3),0.3,dxfattribs={"layer":"COLUMN"}); d.saveas(out/"floor.dxf")
# 6 old polyline with bulges, solids
d = ezdxf.new("R12"); m = d.modelspace()
m.add_polyline2d([(0,0),(10,0,1.0),(10,8),(0,8,-0.5)],close=True,format="xyb"); m.add_solid([(2,2),(4,2),(2,5),(4,5)]); d.saveas(out/"old.dxf")
# 7, 8 GeoJSON: neighbours with a property; with holes and breaklines
from shapely.geometry import Polygon, mapping, LineString, Point, MultiPolygon, box
from shapely.ops import unary_union, voronoi_diagram
from shapely.geometry import MultiPoint
pts = MultiPoint([(random.random()*100,random.random()*100) for _ in range(25)])
cells = [c.intersection(box(0,0,100,100)) for c in voronoi_diagram(pts).geoms]
fs = [{"type":"Feature","properties":{"use":random.choice(["field","wood","town"]),"code":10*(i%3+1)},"geometry":mapping(c)} for i,c in enumerate(cells)]
json.dump({"type":"FeatureCollection","features":fs},open(out/"zones.geojson","w"),indent=1)
lake = Point(50,50).buffer(30,quad_segs=12); isl = Point(55,52).buffer(8,quad_segs=6)
fs = [{"type":"Feature","properties":{},"geometry":mapping(lake.difference(isl))},{"type":"Feature","properties":{},"geometry":mapping(LineString([(25,45),(35,55),(42,48)]))}]
json.dump({"type":"FeatureCollection","features":fs},open(out/"lake.geojson","w"))
# 9 breaklines in a cloud of points
fs = [{"type":"Feature","properties":{},"geometry":{"type":"MultiPoint","coordinates":[[random.random()*100,random.random()*100,random.random()*10] for _ in range(300)]}},
      {"type":"Feature","properties":{},"geometry":{"type":"LineString","coordinates":[[20,20,5],[40,50,6],[80,60,9]]}}]
json.dump({"type":"FeatureCollection","features":fs},open(out/"terrain.json","w"))
# 10, 11 WKT
star = Polygon([(math.cos(i*math.pi/5)*(10 if i%2 else 4),math.sin(i*math.pi/5)*(10 if i%2 else 4)) for i in range(10)])
open(out/"star.wkt","w").write(star.wkt+"\n")
open(out/"parts.wkt","w").write("\n".join(g.wkt for g in [box(0,0,4,4),box(4,0,8,4),MultiPolygon([box(0,4,4,8),box(5,5,8,8)]),LineString([(1,1),(3,2)])]))
# 12, 13 shapefiles
import shapefile
w = shapefile.Writer(str(out/"land"), shapeType=shapefile.POLYGON); w.field("NAME","C"); w.field("CODE","N")
w.poly([[(0,0),(0,10),(10,10),(10,0),(0,0)],[(2,2),(4,2),(4,4),(2,4),(2,2)]]); w.record("west",7)
w.poly([[(10,0),(10,10),(20,12),(22,3),(10,0)]]); w.record("east",9); w.close()
w = shapefile.Writer(str(out/"survey"), shapeType=shapefile.POINTZ); w.field("ID","N")
for i in range(200): x,y=random.random()*50,random.random()*30; w.pointz(x,y,math.sin(x/9)+y/20); w.record(i)
w.close()
# 14 LAS
import laspy, numpy as np
h = laspy.LasHeader(point_format=6, version="1.4"); h.scales=[0.01]*3; h.offsets=[500000,4600000,100]
l = laspy.LasData(h); n=2000; rng=np.random.default_rng(3)
l.x=500000+rng.random(n)*100; l.y=4600000+rng.random(n)*100; l.z=100+rng.random(n)*5; l.write(str(out/"scan.las"))
# 15, 16 columns
with open(out/"soundings.csv","w") as f:
    f.write("id;lon;lat;depth;z\n"); [f.write(f"{i};{random.random():.6f};{random.random():.6f};x;{random.random()*30:.2f}\n") for i in range(150)]
np.savetxt(out/"cloud.xyz", rng.random((250,3))*[10,10,2], fmt="%.4f")
# 17, 18 matplotlib SVG
import matplotlib; matplotlib.use("svg"); import matplotlib.pyplot as plt
fig,ax=plt.subplots(figsize=(4,3)); ax.pie([3,5,2],labels=None); fig.savefig(out/"pie.svg"); plt.close(fig)
fig=plt.figure(figsize=(3,2)); from matplotlib.patches import PathPatch; from matplotlib.textpath import TextPath
ax=fig.add_axes([0,0,1,1]); ax.axis("off"); ax.set_xlim(0,60); ax.set_ylim(0,30); ax.add_patch(PathPatch(TextPath((2,8),"R&8",size=24),fc="k",ec="none")); fig.patch.set_visible(False)
fig.savefig(out/"letters.svg"); plt.close(fig)
# 19 fontTools SVG
from fontTools.ttLib import TTFont; from fontTools.pens.svgPathPen import SVGPathPen
font=TTFont("/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf"); gs=font.getGlyphSet(); x=0; ps=[]
for ch in "ae8@":
    g=font.getBestCmap()[ord(ch)]; pen=SVGPathPen(gs); gs[g].draw(pen); ps.append(f'<path transform="translate({x} 0)" d="{pen.getCommands()}"/>'); x+=gs[g].width
open(out/"glyphs.svg","w").write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 -2000 {x} 2500"><g transform="scale(1,-1)">{"".join(ps)}</g></svg>')
# 20 inkscape-like
open(out/"inkscape.svg","w").write('''<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd">
<svg width="210mm" height="297mm" viewBox="0 0 210 297" xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd">
 <style>.cut{fill:none;stroke:#f00} #p1 {fill:#00ff00}</style>
 <defs><circle id="hole" r="6"/></defs><sodipodi:namedview id="nv"/>
 <g transform="matrix(1,0,0,1,10,20)"><rect class="cut" x="5" y="5" width="150" height="90" rx="12"/>
 <use xlink:href="#hole" x="35" y="50" style="fill:#000"/><use href="#hole" transform="rotate(30) translate(90,0)"/>
 <path id="p1" d="m 70,40 c 10,-20 30,-20 40,0 s 5,30 -15,30 q -20,5 -25,-10 t 0,-20 z"/><path class="cut" d="M 120 30 a 15 8 20 1 1 10 20"/></g>
 <text x="20" y="150">cut me</text><image href="x.png"/></svg>''')

# What a command needs besides the name of the drawing.
OPTIONS = {"zones.geojson": ["--property", "use"], "land.shp": ["--property", "CODE"]}


def run(program, *words):
    return subprocess.run([program, *map(str, words)], capture_output=True, text=True, timeout=600)


def mesh_all(program):
    failed = 0
    endings = {".dxf", ".geojson", ".json", ".wkt", ".shp", ".las", ".csv", ".xyz", ".svg"}
    names = sorted(p for p in out.iterdir() if p.suffix in endings)
    for path in names:
        options = OPTIONS.get(path.name, [])
        mesh = out / (path.name + ".mesh.ele")
        made = run(program, "mesh", path, *options, "-o", mesh)
        checked = run(program, "check", mesh, "--input", path, *options)
        is_good = made.returncode == 0 and checked.returncode == 0
        failed += not is_good
        lines = checked.stdout.splitlines() or [made.stderr]
        print("ok  " if is_good else "FAIL", path.name, lines[-1].split(": ", 1)[-1], flush=True)
        if not is_good:
            print(made.stderr, checked.stderr)
    print(f"{len(names)} drawings, {failed} failed")
    return failed


if len(sys.argv) > 2:
    sys.exit(min(mesh_all(sys.argv[2]), 1))
